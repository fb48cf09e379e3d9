using Headless.Bench.Model;
using Headless.Bench.Scene;
using Headless.Checks;
using Headless.Measure;
using Headless.Player.Commands;
using SphFluid.Validation;

namespace Headless.Help;

/// <summary>The verbs of <c>./run</c>. Their flags are those that the parsers read.</summary>
internal static class Verbs
{
    private const string Resumed = "Runs that the tables in DIR have are not done again: the same command goes on where an interrupted one stopped.";

    private const string Sharded = "With --shard I/N and no --out, DIR is that folder with -I-of-N behind its name. A shard draws nothing; ./run merge does.";

    public static IReadOnlyList<Verb> All { get; } =
    [
        new("play", "plays a scene and writes its pictures, film and figures")
        {
            Words = "[SCENE] [flags]",
            OfPlayer = PlayOptions.Flags, Own = OfPackage("play"),
            Notes = ["writes DIR/frame_00000.png..., film.mp4, timings.csv and summary.json"],
            Examples =
            [
                ("", "a second and a half of the sample Dam Break: a film in Build/play, in under a minute on two CPU cores"),
                ("--open --size 1280x720 --fps 30", "the same in HD, shown when it is done"),
                ("Fountain --seconds 5", "another sample (./run list names them); a path of a .unity file does as well"),
                ("--particles 4000 --surface particles --seconds 1 --size 640x360", "a quick look with fewer particles"),
                ("--no-images --seconds 4 --record record.csv --state end.ply --mesh end-surface.ply", "figures, particles and surface; no pictures"),
            ],
        },
        Measured("bench", "the thesis's tables 3 and 4, the methods' steps and the surfaces against each other, as CSV") with
        {
            Notes =
            [
                "writes DIR/thesis.csv, solver.csv, surface.csv and, with the sweep, sweep.csv after every round",
                "Without --particles and --grids: thesis 16384, 32768 and 65536 particles, 32 to 256 cells; solver 16384 to 262144, on a real GPU to 4194304; surface 16384 to 262144, on a real GPU to 1048576, 32 to 512 cells.",
            ],
            Other = ("With --table scene it plays a scene, writes DIR/scene.csv, and scene-frames.csv with the passes of every frame, and takes", SceneOptions.Flags),
            Examples =
            [
                ("--table surface --particles 4096 --grids 32", "a small table: a minute or two on two CPU cores"),
                ("--table solver --particles 65536 --repeat 9", "the methods' steps, nine samples of each"),
                ("--table scene --against ../before --phases 0-1", "this build against another one, frame by frame in turns"),
            ],
        },
        Measured("chart", "error against GPU time of every validation case, as CSV and pictures") with
        {
            Notes = ["writes DIR/accuracy.csv after every run and at the end accuracy.svg, accuracy.png, pareto.csv, equal-cost.csv and case-NAME.png", Resumed, Sharded],
            Examples =
            [
                ("--quick", "fewer points"), ("--case hydrostatic --method standard", "one case of one method"),
                ("--shard 2/8 --out Build/shards/2", "the second of eight machines' parts of a full chart"),
            ],
        },
        Measured("choose", "which method, which spacing: for an error or a time, from this device's chart") with
        {
            Notes =
            [
                "reads the newest chart of the device in benchmarks/accuracy and Build/chart; writes DIR/choose.csv, choose.svg and choose.png, with --narrow DIR/accuracy.csv, with --verify DIR/choose-verify.csv",
                "Where nothing that was measured keeps what is asked, it names the nearest ways, and the exit code is 1.",
                "For a liquid of another size than the case's own give --length, and --volume where its shape is another; --speed where no gravity moves it.",
            ],
            Examples =
            [
                ("--case splash --error 5% --ms 4", "the fastest way to 5 %, if 4 ms a frame hold it; else the nearest in both directions"),
                ("--case waves --ms 2 --length 1.5 --volume 9", "the most accurate way for 9 cubic metres of water 1.5 m deep in 2 ms"),
                ("--verify 10 --out Build/verify", "ten questions, each answer run and compared"),
            ],
        },
        Measured("stability", "where the methods are stable, as CSV and pictures") with
        {
            Notes = ["writes DIR/stability.csv and limits.csv after every run and at the end stability-m1.svg, stability-m1.png and so on", Resumed, Sharded],
            Examples = [("--quick", "fewer points"), ("--map M1 --method standard", "one map of one method")],
        },
        Measured("leaks", "scenes that no liquid may leak from, as CSV") with
        {
            Notes = ["writes DIR/leaks.csv after every run", Sharded],
            Examples = [("--scene still-cup funnel", "two scenes")],
        },
        Measured("surfaces", "how good surfaces of known liquids are, as CSV") with
        {
            Notes = ["writes DIR/surface-quality.csv after every variant of every state", Sharded],
            Examples = [("--quick", "fewer variants"), ("--state sphere --variant default", "one surface of one state")],
        },
        Measured("merge", "the shards of a chart, of stability maps, leaks or surfaces as the whole: tables, pictures, report") with
        {
            Words = "FOLDER... [flags]",
            Notes =
            [
                "FOLDER... are those that measurements with --shard wrote to, all of one command, commit, device and plan; otherwise exit code 2 and what differs.",
                "writes the verb's files to DIR, and DIR/shards.csv. Runs that no shard has are named, with exit code 1; what there is is written.",
            ],
            Examples =
            [
                ("Build/shards/* --out Build/chart-whole", "all shards of a sweep"),
                ("Build/shards/* --errors-only", "without times: shards of several devices, or of one that they shared"),
            ],
        },
        Measured("budgets", "what the method Automatic picks for a budget, against the ways that it has, as CSV") with
        {
            Notes = ["writes DIR/budgets.csv after every run, and the errors with the last"],
            Examples = [("--budget 4 16 --particles 1000 --repeat 1", "two budgets, each once: a minute or two on two CPU cores")],
        },
        Measured("export", "a scene's liquids as cases of PySPH, which runs on many processors") with
        {
            Words = "[SCENE] [flags]",
            Notes =
            [
                "writes DIR/case.py, its data, run.sh, job.sbatch, to_sequence.py and manifest.json; several liquids each to a folder of its name",
                "What PySPH cannot express is named, with the object that has it.",
            ],
            Examples =
            [
                ("--particles 4000 --seconds 0.5", "the sample Dam Break with 4,000 particles; then bash Build/export/run.sh"),
                ("WaveTank --seconds 4 --ranks 8", "a scene whose paddle moves, for eight processes"),
            ],
        },
        Measured("peers", "cases of the chart computed by another program, PySPH, as CSV and a picture") with
        {
            Notes =
            [
                "writes DIR/peers.csv after every run and at the end peers-compared.csv, peers.svg and peers.png",
                "PySPH computes on the CPU with all cores; Debian: apt-get install python3-pysph", Resumed,
            ],
            Examples = [("--quick", "each case once, coarse"), ("--case couette dam-break", "two cases at all spacings")],
        },
        new("figures", "pictures of what the thesis's printed forms do") { Own = OfPackage("figures"), Examples = [("--out Build/figures", "all of them")] },
        new("check", "conformance checks that need no GPU")
        {
            Own = CheckOptions.Flags,
            Examples = [("", "all of them: minutes"), ("--only form", "package form and metas: seconds"), ("--only docs", "what the documents name and claim: half a minute")],
        },
        new("measure", "this device in a few minutes: steps, surfaces, scenes, pictures, tests and equal states, as tables and a page")
        {
            Own = MeasureOptions.Flags,
            Notes =
            [
                "writes DIR/summary.txt, parts.csv and report.html after every part, solver.csv, surface.csv, water.csv, accuracy.csv, pictures, logs/ and a folder a part",
                "A part that takes too long, crashes or runs out of memory is named with its last lines; the results of the others stay. The exit code is 1 then.",
                "For a machine without .NET: ./run publish --measure.",
            ],
            Examples =
            [
                ("", "ten minutes on the graphics card"), ("--minutes 3 --parts solver,scene", "two parts in three minutes"),
                ("--small --minutes 15 --device llvmpipe", "a rehearsal on two CPU cores"),
            ],
        },
        new("model", "what steps would take on GPUs that are not at hand, with every assumption")
        {
            Own = ModelCommand.Flags, Examples = [("", "from the tables that are committed")],
        },
        new("mutate", "how many small changes of kernels and C# the tests catch")
        {
            Own = Mutation.Options.Flags, Examples = [("--only StandardDensity", "after work on that kernel")],
        },
        new("docs", "the manual and the API reference as pages for a browser")
        {
            Words = "", Notes = ["writes Build/docs, to be opened at Build/docs/index.html; Doxygen is installed by apt where it is missing"],
        },
        new("list", "the scenes, liquids and methods that play takes by name") { Words = "" },
        new("devices", "the graphics devices of this machine") { Words = "" },
        new("publish", "the player as one folder that needs no .NET")
        {
            Words = "[DIR] [flags]",
            Own =
            [
                new("--system", "NAME", "what it is to run on", "linux") { Choices = ["linux", "windows"] },
                new("--measure", "NAME", "the same with what ./run measure needs: project, tests, compiled shaders; then run.sh or run.cmd in it measures")
                {
                    Choices = ["linux", "windows"],
                },
            ],
            Notes =
            [
                "DIR is Build/publish unless named, with --measure Build/measure-linux or Build/measure-windows: new, empty, or what publish wrote before; anything else is refused.",
                "With --measure it takes the shaders that this machine has compiled, every variant of the packages' and those of what was run; it plays samples on a software device, for their states.",
            ],
            Examples =
            [
                ("../sphplayer", "a folder to copy to other machines"), ("--measure windows ../kit", "what measures a machine with Windows and a Vulkan driver"),
            ],
        },
        new("build", "builds the player, the package, the checks and all tests; the other verbs build what they need by themselves")
        {
            Words = "[SOLUTION]", Notes = ["SOLUTION is Headless.slnx unless named; Play.slnx is the part that plays and measures."],
        },
        new("help", "the same as --help") { Words = "[VERB]", Notes = ["./run help --update writes the texts anew after a change of flags."] },
    ];

    private static Verb Measured(string name, string summary) =>
        new(name, summary) { OfPlayer = [.. ExecOptions.Flags], Own = OfPackage(name) };

    private static Flag[] OfPackage(string verb) =>
        [.. CommandLineHelp.FlagsOf(verb).Select(f => new Flag(f.Name, f.Value, f.Text, f.Absent) { Choices = f.Choices })];
}
