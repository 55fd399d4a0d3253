s/about [0-9.e-]+ (s|min|h|days) of processor time/about * of processor time/
s/It is [0-9.]+ times (faster|slower)/It is * times faster/
# Columns "us" and "speed" of the first table, "time" of the second; all are at the end of a line.
s/ +us +speed$/ us speed/
s/ +time$/ time/
/^ *[0-9.e-]+( \*)? .* [0-9.]+ +[0-9.]+$/s/ +[0-9.]+ +[0-9.]+$/ * */
s/ +[0-9.e-]+ (s|min|h)$/ */
s/realisations, [0-9.e-]+ (s|min|h);/realisations, *;/
