/* Compiles a list of HLSL jobs with Microsoft's d3dcompiler_47.dll in one process.
 *
 * A job (see jobs.h):
 *   id <TAB> source file <TAB> entry point <TAB> target profile [<TAB> file for the compiled shader]
 * Its result:
 *   id <TAB> ok|failed <TAB> uavs <TAB> groupshared bytes <TAB> threads <TAB> instruction slots <TAB> messages <TAB>
 *   buffers (read or written) <TAB> KB that the compilation asked for <TAB> ms of CPU time that it took
 */
#include <windows.h>
#include <d3dcompiler.h>
#include "jobs.h"

typedef HRESULT(WINAPI *compile_fn)(LPCVOID, SIZE_T, LPCSTR, const D3D_SHADER_MACRO *, ID3DInclude *, LPCSTR, LPCSTR, UINT, UINT, ID3DBlob **, ID3DBlob **);
typedef HRESULT(WINAPI *disassemble_fn)(LPCVOID, SIZE_T, UINT, LPCSTR, ID3DBlob **);

typedef struct { int uavs, shared_bytes, threads, slots, buffers; } figures;

/* Milliseconds of the processor that this thread has used. */
static int cpu_ms(void)
{
    FILETIME created, ended, kernel, user;
    GetThreadTimes(GetCurrentThread(), &created, &ended, &kernel, &user);
    unsigned long long ticks = ((unsigned long long)kernel.dwHighDateTime << 32) + kernel.dwLowDateTime
        + ((unsigned long long)user.dwHighDateTime << 32) + user.dwLowDateTime;
    return (int)(ticks / 10000);
}

static int is_buffer(const char *line)
{
    static const char *const kinds[] = {
        "dcl_resource_structured", "dcl_resource_raw", "dcl_resource_buffer", "dcl_uav_structured", "dcl_uav_raw", "dcl_uav_typed_buffer",
    };
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (!strncmp(line, kinds[i], strlen(kinds[i]))) return 1;
    return 0;
}

/* The declarations of a D3D assembly listing, for example
 *   dcl_uav_structured u0, 8
 *   dcl_resource_raw t0
 *   dcl_tgsm_structured g0, 8, 1024      (stride, count)
 *   dcl_thread_group 1024, 1, 1
 *   // Approximately 45 instruction slots used */
static figures read_listing(const char *listing)
{
    figures f = {0, 0, 0, 0, 0};
    for (const char *line = listing; line && *line; line = strchr(line, '\n')) {
        if (*line == '\n') line++;
        int a, b, c;
        if (!strncmp(line, "dcl_uav", 7)) f.uavs++;
        if (is_buffer(line)) f.buffers++;
        if (sscanf(line, "dcl_tgsm_structured g%d, %d, %d", &a, &b, &c) == 3) f.shared_bytes += b * c;
        if (sscanf(line, "dcl_tgsm_raw g%d, %d", &a, &b) == 2) f.shared_bytes += b;
        if (sscanf(line, "dcl_thread_group %d, %d, %d", &a, &b, &c) == 3) f.threads = a * b * c;
        sscanf(line, "// Approximately %d instruction slots", &f.slots);
        if (!*line) break;
    }
    return f;
}

static int write_file(const char *path, ID3DBlob *blob)
{
    FILE *file = fopen(path, "wb");
    if (!file) return 0;
    size_t size = blob->lpVtbl->GetBufferSize(blob);
    size_t written = fwrite(blob->lpVtbl->GetBufferPointer(blob), 1, size, file);
    return !fclose(file) && written == size;
}

/* Bytes that the compiler asked the system for: what its passes did, the same on every machine, unlike its time. */
static unsigned long long asked_bytes;
static void *(WINAPI *heap_alloc)(HANDLE, DWORD, SIZE_T);
static void *(WINAPI *virtual_alloc)(void *, SIZE_T, DWORD, DWORD);

static void *WINAPI counted_heap_alloc(HANDLE heap, DWORD flags, SIZE_T size)
{
    asked_bytes += size;
    return heap_alloc(heap, flags, size);
}

static void *WINAPI counted_virtual_alloc(void *address, SIZE_T size, DWORD type, DWORD access)
{
    asked_bytes += size;
    return virtual_alloc(address, size, type, access);
}

/* Puts a function in the place of one that a module imports; returns the one before, or null where it imports none of that name. */
static void *replace_import(HMODULE module, const char *name, void *function)
{
    BYTE *base = (BYTE *)module;
    const IMAGE_NT_HEADERS *headers = (const IMAGE_NT_HEADERS *)(base + ((const IMAGE_DOS_HEADER *)base)->e_lfanew);
    const DWORD at = headers->OptionalHeader.DataDirectory[IMAGE_DIRECTORY_ENTRY_IMPORT].VirtualAddress;
    for (const IMAGE_IMPORT_DESCRIPTOR *library = (const void *)(base + at); library->Name; library++) {
        const IMAGE_THUNK_DATA *names = (const void *)(base + library->OriginalFirstThunk);
        IMAGE_THUNK_DATA *functions = (void *)(base + library->FirstThunk);
        for (; names->u1.AddressOfData; names++, functions++) {
            if (IMAGE_SNAP_BY_ORDINAL(names->u1.Ordinal) || strcmp(((const IMAGE_IMPORT_BY_NAME *)(base + names->u1.AddressOfData))->Name, name)) continue;
            void *before = (void *)functions->u1.Function;
            DWORD access;
            if (!VirtualProtect(functions, sizeof *functions, PAGE_READWRITE, &access)) return NULL;
            functions->u1.Function = (ULONG_PTR)function;
            VirtualProtect(functions, sizeof *functions, access, &access);
            return before;
        }
    }
    return NULL;
}

static compile_fn compile;
static disassemble_fn disassemble;

static int run_job(char *line)
{
    char *id = strtok(line, "\t\r\n"), *path = strtok(NULL, "\t\r\n"), *entry = strtok(NULL, "\t\r\n");
    char *target = strtok(NULL, "\t\r\n"), *output = strtok(NULL, "\t\r\n");
    if (!target) { printf("%s\tfailed\t0\t0\t0\t0\tmalformed job line\n", id ? id : "?"); return 1; }
    size_t size;
    char *source = read_file(path, &size);
    if (!source) { printf("%s\tfailed\t0\t0\t0\t0\tcannot read %s\n", id, path); return 1; }
    ID3DBlob *code = NULL, *messages = NULL, *listing = NULL;
    const UINT optimise = 1 << 15, ieee_strictness = 0;
    const int start = cpu_ms();
    asked_bytes = 0;
    const HRESULT hr = compile(source, size, path, NULL, NULL, entry, target, optimise | ieee_strictness, 0, &code, &messages);
    const int ms = cpu_ms() - start, asked_kb = (int)(asked_bytes >> 10);
    int failed = FAILED(hr) || !code;
    if (!failed && output && !write_file(output, code)) {
        printf("%s\tfailed\t0\t0\t0\t0\tcannot write %s\n", id, output);
        fflush(stdout);
        exit(CANNOT_WRITE);
    }
    figures f = {0, 0, 0, 0, 0};
    if (!failed && SUCCEEDED(disassemble(code->lpVtbl->GetBufferPointer(code), code->lpVtbl->GetBufferSize(code), 0, NULL, &listing)))
        f = read_listing(listing->lpVtbl->GetBufferPointer(listing));
    printf("%s\t%s\t%d\t%d\t%d\t%d\t", id, failed ? "failed" : "ok", f.uavs, f.shared_bytes, f.threads, f.slots);
    if (messages) print_one_line(messages->lpVtbl->GetBufferPointer(messages));
    printf("\t%d\t%d\t%d\n", f.buffers, asked_kb, ms);
    if (code) code->lpVtbl->Release(code);
    if (messages) messages->lpVtbl->Release(messages);
    if (listing) listing->lpVtbl->Release(listing);
    free(source);
    return failed;
}

int main(int argc, char **argv)
{
    if (argc != 2) { fprintf(stderr, "usage: fxc_jobs JOBS\n"); return BAD_USAGE; }
    HMODULE library = LoadLibraryA("d3dcompiler_47.dll");
    if (!library) { fprintf(stderr, "d3dcompiler_47.dll not found beside fxc_jobs.exe\n"); return NO_LIBRARY; }
    compile = (compile_fn)(void *)GetProcAddress(library, "D3DCompile");
    disassemble = (disassemble_fn)(void *)GetProcAddress(library, "D3DDisassemble");
    if (!compile || !disassemble) { fprintf(stderr, "d3dcompiler_47.dll has no D3DCompile or no D3DDisassemble\n"); return NO_ENTRY_POINT; }
    heap_alloc = replace_import(library, "HeapAlloc", counted_heap_alloc);
    virtual_alloc = replace_import(library, "VirtualAlloc", counted_virtual_alloc);
    if (!heap_alloc || !virtual_alloc) { fprintf(stderr, "d3dcompiler_47.dll does not import HeapAlloc and VirtualAlloc\n"); return NO_ENTRY_POINT; }
    return run_jobs(argv[1], run_job);
}
