/* Compiles a list of HLSL jobs with Microsoft's dxcompiler.dll (DXC) in one process.
 *
 * A job (see jobs.h): id <TAB> source file <TAB> entry point <TAB> target profile
 * Its result:         id <TAB> ok|failed <TAB> bytes of DXIL <TAB> messages
 */
#define COBJMACROS
#include <windows.h>
#include <d3dcommon.h>
#include "jobs.h"

/* Of Microsoft's public dxcapi.h: what is called here. */
typedef struct { const void *data; SIZE_T size; UINT encoding; } source_buffer;
typedef HRESULT(WINAPI *create_fn)(const GUID *, const GUID *, void **);

static const GUID compiler_class = {0x73e22d93, 0xe6ce, 0x47f3, {0xb5, 0xbf, 0xf0, 0x66, 0x4f, 0x39, 0xc1, 0xb0}};
static const GUID compiler_interface = {0x228b4687, 0x5a6a, 0x4730, {0x90, 0x0c, 0x97, 0x02, 0xb2, 0x20, 0x3f, 0x54}};
static const GUID result_interface = {0x58346cda, 0xdde7, 0x4497, {0x94, 0x61, 0x6f, 0x87, 0xaf, 0x5e, 0x06, 0x59}};

typedef struct compiler compiler;
typedef struct {
    HRESULT(WINAPI *query)(compiler *, const GUID *, void **);
    ULONG(WINAPI *add)(compiler *);
    ULONG(WINAPI *release)(compiler *);
    HRESULT(WINAPI *compile)(compiler *, const source_buffer *, LPCWSTR *, UINT32, void *, const GUID *, void **);
} compiler_table;
struct compiler { const compiler_table *table; };

typedef struct result result;
typedef struct {
    HRESULT(WINAPI *query)(result *, const GUID *, void **);
    ULONG(WINAPI *add)(result *);
    ULONG(WINAPI *release)(result *);
    HRESULT(WINAPI *status)(result *, HRESULT *);
    HRESULT(WINAPI *code)(result *, ID3DBlob **);
    HRESULT(WINAPI *messages)(result *, ID3DBlob **);
} result_table;
struct result { const result_table *table; };

static compiler *dxc;

static int run_job(char *line)
{
    char *id = strtok(line, "\t"), *path = strtok(NULL, "\t"), *entry = strtok(NULL, "\t"), *target = strtok(NULL, "\t\r\n");
    if (!target) { printf("%s\tfailed\t0\tmalformed job line\n", id ? id : "?"); return 1; }
    size_t size;
    char *text = read_file(path, &size);
    if (!text) { printf("%s\tfailed\t0\tcannot read %s\n", id, path); return 1; }
    WCHAR wide_entry[256], wide_target[16];
    MultiByteToWideChar(CP_UTF8, 0, entry, -1, wide_entry, 256);
    MultiByteToWideChar(CP_UTF8, 0, target, -1, wide_target, 16);
    LPCWSTR words[] = {L"-E", wide_entry, L"-T", wide_target, L"-HV", L"2018", L"-Vd", L"-Wno-logical-op-parentheses"};
    source_buffer source = {text, size, CP_UTF8};
    result *outcome = NULL;
    HRESULT status = dxc->table->compile(dxc, &source, words, sizeof words / sizeof *words, NULL, &result_interface, (void **)&outcome);
    ID3DBlob *code = NULL, *messages = NULL;
    if (SUCCEEDED(status)) outcome->table->status(outcome, &status);
    if (outcome) { outcome->table->code(outcome, &code); outcome->table->messages(outcome, &messages); }
    int failed = FAILED(status) || !code;
    printf("%s\t%s\t%d\t", id, failed ? "failed" : "ok", code ? (int)ID3D10Blob_GetBufferSize(code) : 0);
    if (messages && ID3D10Blob_GetBufferSize(messages)) print_one_line(ID3D10Blob_GetBufferPointer(messages));
    putchar('\n');
    if (code) ID3D10Blob_Release(code);
    if (messages) ID3D10Blob_Release(messages);
    if (outcome) outcome->table->release(outcome);
    free(text);
    return failed;
}

int main(int argc, char **argv)
{
    if (argc != 2) { fprintf(stderr, "usage: dxc_jobs JOBS\n"); return BAD_USAGE; }
    HMODULE library = LoadLibraryA("dxcompiler.dll");
    if (!library) { fprintf(stderr, "dxcompiler.dll cannot be loaded (%lu)\n", GetLastError()); return NO_LIBRARY; }
    create_fn create = (create_fn)(void *)GetProcAddress(library, "DxcCreateInstance");
    if (!create || FAILED(create(&compiler_class, &compiler_interface, (void **)&dxc))) { fprintf(stderr, "dxcompiler.dll makes no compiler\n"); return NO_ENTRY_POINT; }
    return run_jobs(argv[1], run_job);
}
