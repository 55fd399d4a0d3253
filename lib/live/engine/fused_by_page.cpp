// The linker calls this in place of the C library's fma: the page knows which of two modules is faster and right.

extern "C" {
__attribute__((import_module("page"), import_name("fused"))) double page_fused(double a, double b, double c);
double __wrap_fma(double a, double b, double c);
double __wrap_fma(double a, double b, double c) { return page_fused(a, b, c); }
}
