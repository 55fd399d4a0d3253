// Exceptions end an instance: the C++ library of this target has none. The page is told why, and makes another instance.

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <typeinfo>

#include "rocking/base/error.hpp"

extern "C" {

/// Of the page. Throws an exception of its own, so that it does not return.
[[noreturn]] __attribute__((import_module("page"), import_name("fail"))) void page_fail(const char* text,
                                                                                        std::size_t size);

void* __cxa_allocate_exception(std::size_t size) noexcept;
[[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*destroy)(void*));

void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }
void __cxa_throw(void* thrown, std::type_info* type, void (* /*destroy*/)(void*)) {
  const bool is_input = *type == typeid(rocking::base::InputError);
  const std::string_view text = is_input ? static_cast<rocking::base::InputError*>(thrown)->what() : type->name();
  page_fail(text.data(), text.size());
}
}
