using System;
using System.IO;
using System.Linq;
using System.Text;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What objects of a scene are called is data to the scripts of a case, and no part of them.</summary>
    public sealed class ExportNamesTests
    {
        // Stands in for NumPy and PySPH with an object that can be asked for anything.
        private const string Check = @"
import ast, csv, importlib.util, os, sys, types

class Anything(types.ModuleType):
    def __getattr__(self, name):
        if name.startswith('__'): raise AttributeError(name)
        return self
    def __call__(self, *_, **__): return self
    def __getitem__(self, _): return self
    def __mul__(self, _): return self
    def __add__(self, _): return self
    def __int__(self): return 1
    def __iter__(self): return iter(())

anything = Anything('anything')
anything.Application = object
for name in ('numpy', 'pysph', 'pysph.base.kernels', 'pysph.base.nnps', 'pysph.base.utils', 'pysph.solver.application', 'pysph.solver.utils', 'pysph.sph.integrator',
             'pysph.sph.scheme', 'pysph.sph.wc.edac', 'pysph.tools.interpolator'):
    sys.modules[name] = anything
try:
    import resource
except ImportError:
    sys.modules['resource'] = anything  # of Unix only
os.chdir(os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

def loaded(file):
    with open(file, encoding='utf-8') as text: ast.parse(text.read(), file)
    spec = importlib.util.spec_from_file_location(file[:-3], file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module

with open('names.txt') as text: names = [bytes.fromhex(line.strip()).decode() for line in text]
case, readings = loaded('case.py'), loaded('readings.py')
loaded('to_sequence.py')
given = case.given
assert [given['simulation'], given['scene'], given['commit'], given['bodies'][0]['name']] == names[:4]
assert [note['text'] for note in given['notExported']] == [names[2]]
assert [reading['name'] for reading in given['readings']] == names
readings.main('out', 'table.csv')
columns = ['time_s'] + ['%s.%s' % (p['name'], p['property']) for p in readings.probes] + [g['name'] + '.height_m' for g in readings.gauges]
assert len(columns) == len(names) + 1
if sys.version_info >= (3, 11):  # older ones read no NUL
    with open('table.csv', newline='', encoding='utf-8') as text: assert next(csv.reader(text)) == columns
print(case.dx, case.rho0, case.nu, case.c0, case.gravity, case.seconds, case.frame_rate, case.box, case.periodic, case.solids, given['scheme'])
print(len(names), 'names')
";

        private static readonly string[] Scripts = { "case.py", "to_sequence.py", "readings.py", "run.sh", "job.sbatch" };
        private static readonly string[] Properties = { "p", "rho", "u", "height" };

        private string path;

        [SetUp]
        public void SetUp() => path = TestFolder.Fresh();

        [TearDown]
        public void TearDown() => TestFolder.Delete(path);

        private static PysphCase Case(string[] names) =>
            new PysphCase(names[0], new ExportConstants
            {
                DomainSize = new Vector3(1.8f, 1.2f, 0.8f), Spacing = 0.025f, Density = 998f, Viscosity = 1e-6f, SoundSpeed = 21.5f,
                Gravity = new Vector3(0f, -9.81f, 0f),
                Boundaries = new FluidBoundaries { Periodic = FluidAxes.Z },
            }, new FluidExportOptions { Scene = names[1], Commit = names[2], Seconds = 0.5, FrameRate = 60.0, Ranks = 7 })
            {
                Walls = new WallParticle[2],
                Bodies = new[] { new ExportBody(names[3], new WallParticle[1], new[] { new BodyPose { Rotation = Quaternion.identity } }) },
                Instruments = names
                    .Select((name, i) =>
                        new ExportInstrument { Name = name, Property = Properties[i % Properties.Length], Up = Vector3.up, Length = 1f })
                        .ToArray(),
                Messages = new[] { new FluidMessage(FluidSeverity.Warning, FluidIssue.NotExported, null, names[2], names[3]) },
            };

        private string[] Texts() => Scripts.Select(s => File.ReadAllText(Path.Combine(path, s))).ToArray();

        [Test]
        public void ScriptsAreTheSameWhateverThingsAreCalled()
        {
            Case(new[] { "Tank", "Scene", "abc", "Paddle", "Probe" }).Write(path);
            string[] plain = Texts(), files = Directory.GetFiles(path);
            foreach (int seed in Enumerable.Range(0, 20))
            {
                Case(HostileNames.Make(5, seed).ToArray()).Write(path); // over the last, whose manifest it reads

                Assert.That(Texts(), Is.EqualTo(plain), $"seed {seed}");
                Assert.That(Directory.GetFiles(path), Is.EquivalentTo(files));
            }
        }

        [Test]
        public void ShellScriptsParse()
        {
            Case(HostileNames.Make(5, 1).ToArray()).Write(path);
            foreach (string script in new[] { "run.sh", "job.sbatch" }) Programs.Run("bash", "-n", Path.Combine(path, script));
        }

        [Test]
        public void PythonReadsTenThousandNamesBack()
        {
            string[] names = HostileNames.Make(10_000, 2).ToArray();
            Case(names).Write(path);
            File.WriteAllLines(Path.Combine(path, "names.txt"),
                names.Select(n => BitConverter.ToString(Encoding.UTF8.GetBytes(HostileNames.InUtf8(n))).Replace("-", "")));
            File.WriteAllText(Path.Combine(path, "check.py"), Check);

            string[] said = Programs.Run("python3", Path.Combine(path, "check.py")).Split('\n');

            Assert.That(said[1].Trim(),
                Is.EqualTo(
                    "0.025 998.0 1e-06 21.5 [0.0, -9.81, 0.0] 0.5 60.0 [1.8, 1.2, 0.8] [False, False, True] ['walls', 'body0'] WCSPH"));
            Assert.That(said[2].Trim(), Is.EqualTo("10000 names"));
            Assert.That(Directory.GetFiles(path, "PWNED"), Is.Empty);
        }

        [Test]
        public void FoldersOfLiquidsAreSafeAndDiffer()
        {
            GameObject[] objects = { new GameObject(), new GameObject() };
            try
            {
                FluidSimulation[] simulations = objects.Select(o => o.AddComponent<FluidSimulation>()).ToArray();
                foreach (string name in new[] { "con", "Lpt1", "TANK", new string('\u00e4', 300), "" }.Concat(HostileNames.Make(2000, 3)))
                {
                    (objects[0].name, objects[1].name) = (name, name.ToLowerInvariant());
                    string[] folders = FluidExport.FoldersOf(simulations, path), last = folders.Select(Path.GetFileName).ToArray();

                    Assert.That(folders.Select(Path.GetFullPath).Select(Path.GetDirectoryName), Is.All.EqualTo(path), name);
                    Assert.That(string.Equals(last[0], last[1], StringComparison.OrdinalIgnoreCase), Is.False, name);
                    foreach (string folder in last)
                    {
                        Assert.That(Encoding.UTF8.GetByteCount(folder), Is.InRange(1, 255));
                        Assert.That(folder,
                            Does.Match(@"^[\p{L}\p{M}\p{Nd}-]+$").And.Not.Match("(?i)^(con|prn|aux|nul|com[0-9]|lpt[0-9])$"));
                    }
                }
            }
            finally
            {
                foreach (GameObject made in objects) UnityEngine.Object.DestroyImmediate(made);
            }
        }
    }
}
