using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Every number and choice that public methods and constructors take, those within values and lists too, is given what it should not
    /// be: an ArgumentException names it, or the call does without it and the liquid goes on with numbers. What has no number is never
    /// taken. What is called is found by reflection: a new method needs no line here, a type that no method took before an example.
    /// </summary>
    public abstract class ArgumentContract
    {
        private static readonly Regex NeverNegative = new Regex("[sS]ize$|[rR]adius$|[sS]pacing$|[mM]ass$|[lL]ength$|[dD]epth$|timeStep$");

        private readonly List<string> failures = new List<string>();
        private readonly List<IDisposable> made = new List<IDisposable>();
        private readonly HashSet<string> used = new HashSet<string>();
        private ContractLiquid liquid;
        private string root;
        private int tried, folders;
        private bool floats;

        /// <summary>Whose calls are tried.</summary>
        protected abstract Assembly Package { get; }

        /// <summary>What takes other numbers too, with the reason. An entry that nothing needs any more fails.</summary>
        protected abstract (string call, string reason)[] Exempt { get; }

        /// <summary>A liquid that runs.</summary>
        protected FluidSimulation Simulation => liquid.Simulation;

        [UnityTest]
        public IEnumerator BadArgumentsAreThrownByName()
        {
            root = TestFolder.Fresh();
            liquid = new ContractLiquid();
            yield return null;
            foreach (MethodBase call in PublicCalls.Of(Package))
            {
                if (!TryPrepare(call, out object[] good)) continue;
                foreach (ArgumentInput input in ArgumentInput.Of(call, p => Example(call, p)))
                    foreach (object bad in BadValues.Of(input.Type, input.Get(good))) Try(call, good, input, bad);
                bool goesOn = false;
                IEnumerator frames = liquid.GoOn(on => goesOn = on);
                while (frames.MoveNext()) yield return frames.Current;
                if (!goesOn || liquid.Exception != null)
                {
                    failures.Add($"STOPPED {PublicCalls.NameOf(call)}: {liquid.Exception ?? liquid.Simulation.StatusMessage}");
                }
                if (liquid.IsDamaged) failures.Add($"DAMAGE {PublicCalls.NameOf(call)}");
                liquid.Simulation.StartSimulation();
                liquid.Listen();
                foreach (IDisposable item in made) item.Dispose();
                made.Clear();
            }
            foreach ((string call, string reason) in Exempt)
                if (!used.Contains(call)) failures.Add($"NEEDLESS {call} is exempt ({reason}) and no longer fails");
            Assert.That(failures, Is.Empty, $"{failures.Count} of {tried}\n" + string.Join("\n", failures));
        }

        [TearDown]
        public void TearDown()
        {
            foreach (IDisposable item in made) item.Dispose();
            liquid?.Dispose();
            if (root != null) TestFolder.Delete(root);
        }

        // Arguments with which the call works.
        private bool TryPrepare(MethodBase call, out object[] good)
        {
            good = null;
            try
            {
                if (!ArgumentInput.Of(call, p => Example(call, p)).Any()) return false;
                good = call.GetParameters().Select(p => Example(call, p)).ToArray();
                try
                {
                    floats = false;
                    Call(call, good);
                }
                catch (ArgumentOutOfRangeException) when (call.DeclaringType == typeof(FluidObstacles))
                {
                    floats = true; // of a mesh that floats
                    Call(call, good);
                }
                return true;
            }
            catch (Exception exception)
            {
                failures.Add($"EXAMPLE {PublicCalls.NameOf(call)} does not work: {exception.GetType().Name} {exception.Message}");
                return false;
            }
        }

        private void Try(MethodBase call, object[] good, ArgumentInput input, object bad)
        {
            tried++;
            string what =
                $"{PublicCalls.NameOf(call)} {input.Parameter}{(input.Name == input.Parameter ? "" : "." + input.Name)} = " +
                $"{BadValues.Text(bad)}", fault = null;
            try
            {
                Call(call, input.With(Fresh(call, good), bad));
                if (!BadValues.IsUsable(bad) || NeverNegative.IsMatch(input.Name) && BadValues.RangeOf(bad).least < 0.0)
                {
                    fault = "SILENT " + what;
                }
            }
            catch (ArgumentException exception)
            {
                bool isNamed = exception.ParamName == input.Parameter || exception.ParamName == input.Name ||
                    exception.Message.IndexOf(input.Name, StringComparison.OrdinalIgnoreCase) >= 0 || call.IsSpecialName;
                if (!isNamed) fault = $"MISNAMED {what}: {exception.Message} ({exception.ParamName})";
            }
            catch (FluidDeviceException exception) when (BadValues.IsUsable(bad) && BadValues.RangeOf(bad).most > 1e9)
            {
                _ = exception; // no device holds as much
            }
            catch (Exception exception)
            {
                fault = $"EXCEPTION {what}: {exception.GetType().Name} {exception.Message}";
            }
            if (fault == null) return;
            string exempt = Exempt.Select(e => e.call).FirstOrDefault(e => Regex.IsMatch(what, e));
            if (exempt != null) used.Add(exempt);
            else failures.Add(fault);
        }

        // Some calls use up what they are given.
        private object[] Fresh(MethodBase call, object[] good)
        {
            var fresh = (object[])good.Clone();
            ParameterInfo[] parameters = call.GetParameters();
            for (int i = 0; i < fresh.Length; i++)
                if (parameters[i].ParameterType == typeof(string) || parameters[i].ParameterType == typeof(WallPatch))
                {
                    fresh[i] = Example(call, parameters[i]);
                }
            return fresh;
        }

        private void Call(MethodBase call, object[] arguments)
        {
            try
            {
                object result = call is ConstructorInfo constructor ? constructor.Invoke(arguments)
                    : call.Invoke(call.IsStatic ? null : Example(call.DeclaringType), arguments);
                if (result is IDisposable item && !(result is FluidQuery)) made.Add(item);
            }
            catch (TargetInvocationException exception)
            {
                throw exception.InnerException;
            }
        }

        // An argument with which the call works.
        private object Example(MethodBase call, ParameterInfo parameter)
        {
            Type type = PublicCalls.Plain(parameter.ParameterType);
            if (type == typeof(FluidQuery)) return QueryFor(call);
            if (call.DeclaringType == typeof(ThesisRules) && type == typeof(FluidSolverSettings))
            {
                return FluidRules.Derive(Rules(FluidMethodKind.Thesis));
            }
            if (parameter.Name == "supportRatio") return 2.0;
            if (parameter.Name == "cellRatio") return 0.5;
            if (call.Name == nameof(TriangleMesh.Deformed)) return ((TriangleMesh)Example(typeof(TriangleMesh))).Vertices;
            if (type == typeof(string)) return parameter.Name == "folder" ? FreshFolder() : "name";
            if (type == typeof(int)) return parameter.Name == "mesh" ? 0 : parameter.Name == "stride" || parameter.Name == "count" ? 4 : 1;
            return Example(type);
        }

        // A request of the kind that is moved: of the method that takes the same otherwise.
        private object QueryFor(MethodBase move)
        {
            string rest = string.Join(",", move.GetParameters().Skip(1).Select(p => p.ParameterType.Name + p.Name));
            MethodInfo add = typeof(FluidQueries).GetMethods()
                .Single(m => m.Name.StartsWith("Add") &&
                    string.Join(",", m.GetParameters().Select(p => p.ParameterType.Name + p.Name)) == rest);
            return add.Invoke(liquid.Simulation.Queries, add.GetParameters().Select(p => Example(add, p)).ToArray());
        }

        /// <summary>A path where nothing is.</summary>
        protected string FreshFolder() => Path.Combine(root, "s" + folders++);

        /// <summary>An argument of a type with which calls work, or whose methods are called.</summary>
        protected virtual object Example(Type type)
        {
            FluidSimulation simulation = liquid.Simulation;
            FluidShaderSet shaders = liquid.Rig.Profile.Shaders;
            if (type.IsEnum)
            {
                return type == typeof(FluidMethodKind) ? FluidMethodKind.Standard : type == typeof(GraphicsBuffer.Target)
                    ? GraphicsBuffer.Target.Structured
                    : type == typeof(SurfaceGridSize) ? SurfaceGridSize.Cells32 : Enum.GetValues(type).GetValue(0);
            }
            if (type == typeof(float)) return 0.05f;
            if (type == typeof(double)) return 0.05;
            if (type == typeof(bool)) return false;
            if (type == typeof(long)) return 4L;
            if (type == typeof(int)) return 1;
            if (type == typeof(uint)) return 1u;
            if (type == typeof(Vector2)) return 0.1f * Vector2.one;
            if (type == typeof(Vector3)) return 0.1f * Vector3.one;
            if (type == typeof(Vector4)) return Vector4.one;
            if (type == typeof(Vector3Int)) return 4 * Vector3Int.one;
            if (type == typeof(Quaternion)) return Quaternion.identity;
            if (type == typeof(Matrix4x4)) return Matrix4x4.identity;
            if (type == typeof(Vector3[]) || type == typeof(IReadOnlyList<Vector3>))
            {
                return new[] { Vector3.zero, 0.1f * Vector3.up, 0.1f * Vector3.right };
            }
            if (type == typeof(int[])) return new[] { 0, 1, 2 };
            if (type == typeof(Object) || type == typeof(FluidSimulation)) return simulation;
            if (type == typeof(FluidQueries)) return simulation.Queries;
            if (type == typeof(FluidSolver)) return simulation.Solver;
            if (type == typeof(FluidShaderSet)) return shaders;
            if (type == typeof(FluidSolverSettings)) return simulation.Solver.Settings;
            if (type == typeof(FluidBoundaries) || type == typeof(FluidStatistics) || type == typeof(FluidCounters) ||
                type == typeof(ThesisSwitches))
            {
                return Activator.CreateInstance(type);
            }
            if (type == typeof(StandardSettings)) return simulation.Solver.Settings.Own<StandardSettings>();
            if (type == typeof(FluidRuleInput)) return Rules(FluidMethodKind.Standard);
            if (type == typeof(RobustSettings)) return FluidRules.Derive(Rules(FluidMethodKind.Robust)).Own<RobustSettings>();
            if (type == typeof(ThesisSettings)) return FluidRules.Derive(Rules(FluidMethodKind.Thesis)).Own<ThesisSettings>();
            if (type == typeof(IReadOnlyList<FluidParticle>)) return SimulationRig.Read(simulation);
            if (type == typeof(CommandBuffer)) return Made(new CommandBuffer());
            if (type == typeof(NativeArray<FluidParticle>)) return Made(new NativeArray<FluidParticle>(4, Allocator.Persistent));
            if (type == typeof(GraphicsBuffer)) return simulation.Solver.Particles;
            if (type == typeof(ComputeKernel)) return shaders.Kernel("MoveParticles", "MoveParticles");
            if (type == typeof(ComputeShader)) return shaders.ComputeShaders[0];
            if (type == typeof(FluidBuffers)) return simulation.TryGetBuffers(out FluidBuffers buffers) ? buffers : default;
            if (type == typeof(FluidObstacles)) return Obstacles(simulation.Solver.Settings);
            if (type == typeof(TriangleMesh)) return TriangleMesh.Box(Matrix4x4.Scale(0.1f * Vector3.one));
            if (type == typeof(Collider)) return Box();
            if (type == typeof(WallForces)) return simulation.Solver.WallForces;
            if (type == typeof(WallPatch)) return Patch(simulation.Solver.WallForces);
            if (type == typeof(SurfaceGrid)) return SurfaceGridSize.Cells32.OverDomain(simulation.DomainSize);
            if (type == typeof(SurfaceFieldSettings))
            {
                return SurfaceFieldSettings.For(FluidSurfaceQuality.Cheap, simulation.Solver.Settings);
            }
            if (type == typeof(SurfaceField)) return Field(simulation.Solver, shaders);
            if (type == typeof(SurfacePolygoniser)) return Made(new SurfacePolygoniser(shaders));
            if (type == typeof(SparseSurface)) return Made(new SparseSurface(shaders));
            if (type == typeof(SurfaceMesh))
            {
                return new SurfaceMesh(new[] { Vector3.zero, Vector3.up, Vector3.right }, new[] { Vector3.up, Vector3.up, Vector3.up },
                    new[] { 0, 1, 2 });
            }
            if (type == typeof(StepClock)) return new StepClock(0.001, 10);
            if (type == typeof(TimeStepAdvice)) return FluidRules.Advise(simulation.Solver.Settings, 1.0);
            if (type == typeof(FluidSupport)) return FluidSupport.Query();
            if (type == typeof(FluidDetectors)) return new FluidDetectors(simulation.Solver.Settings);
            if (type == typeof(FluidSurfaceOptions)) return new FluidSurfaceOptions { Quality = FluidSurfaceQuality.Cheap };
            if (typeof(MonoBehaviour).IsAssignableFrom(type)) return liquid.Rig.NewObject("Subject").AddComponent(type);
            throw new NotSupportedException($"There is no example of {type.Name}. Add one here.");
        }

        private BoxCollider Box()
        {
            GameObject holder = liquid.Rig.NewObject("Box");
            holder.layer = SimulationRig.Layer - 1;
            return holder.AddComponent<BoxCollider>();
        }

        /// <summary>Takes what is to be disposed of after the call.</summary>
        protected T Made<T>(T item) where T : IDisposable
        {
            made.Add(item);
            return item;
        }

        private FluidObstacles Obstacles(in FluidSolverSettings settings)
        {
            FluidObstacles obstacles = Made(new FluidObstacles(settings));
            var box = TriangleMesh.Box(Matrix4x4.Scale(0.1f * Vector3.one));
            if (floats) obstacles.AddFloating(box, Vector3.zero, Quaternion.identity, 1f, Vector3.one);
            else obstacles.Add(box, Matrix4x4.identity);
            return obstacles;
        }

        private WallPatch Patch(WallForces forces)
        {
            foreach (WallPatch old in forces.Patches.ToArray()) forces.Remove(old);
            return forces.Add(Vector3.zero, Quaternion.identity, 0.1f * Vector2.one);
        }

        private SurfaceField Field(FluidSolver solver, FluidShaderSet shaders)
        {
            SurfaceField field = Made(new SurfaceField(shaders, SurfaceGridSize.Cells32.OverDomain(solver.Settings.DomainSize)));
            GpuTest.Run(cmd => field.Record(cmd, solver));
            return field;
        }

        private static FluidRuleInput Rules(FluidMethodKind method)
        {
            FluidRuleInput rules = FluidRuleInput.Water;
            (rules.Method, rules.DomainSize, rules.Spacing, rules.LiquidHeight, rules.LiquidDepth) =
                (method, 0.4f * Vector3.one, 0.05f, 0.3f, 0.2f);
            return rules;
        }
    }
}
