using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// No field of a liquid's inspector can be forgotten: a change is in the key of the start, in that of the running liquid, or it is read
    /// otherwise.
    /// </summary>
    public sealed class SettingsEffectTests
    {
        private const BindingFlags Fields = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic |
            BindingFlags.DeclaredOnly;

        /// <summary>Fields of simulations that no key has, each with what reads it.</summary>
        private static readonly Dictionary<string, string> ReadOtherwise = new Dictionary<string, string>
        {
            ["colliderLayers"] = "the collision scene reads it in each frame",
            ["paused"] = "the component reads it in each frame",
            ["timeScale"] = "the clock reads it in each frame",
            ["playOnEnable"] = "the component reads it when it is enabled",
            ["savedStart"] = "a start with a relaxation reads it",
            ["capacityPolicy"] = "the emitters' slots read it in each frame",
            ["capacity"] = "the emitters' slots read it in each frame",
        };

        /// <summary>Fields of profiles that change no liquid.</summary>
        private static readonly Dictionary<string, string> NoPartOfTheLiquid = new Dictionary<string, string>
        {
            ["version"] = "of the stored fields",
        };

        private FluidSimulation simulation;
        private FluidProfile profile, other;

        [SetUp]
        public void Create()
        {
            simulation = new GameObject("Liquid").AddComponent<FluidSimulation>();
            profile = ScriptableObject.CreateInstance<FluidProfile>();
            other = ScriptableObject.CreateInstance<FluidProfile>();
        }

        [TearDown]
        public void Destroy()
        {
            Object.DestroyImmediate(simulation.gameObject);
            Object.DestroyImmediate(profile);
            Object.DestroyImmediate(other);
        }

        private static IEnumerable<string> FieldsOfSimulations() => Leaves(typeof(FluidSimulationSettings)).Select(Name);

        private static IEnumerable<string> FieldsOfProfiles() => Leaves(typeof(FluidProfile)).Select(Name);

        private static IEnumerable<string> PropertiesOfProfiles() =>
            typeof(FluidProfile).GetProperties(Fields).Where(p => p.CanWrite && p.SetMethod.IsPublic).Select(p => p.Name);

        [TestCaseSource(nameof(FieldsOfSimulations))]
        public void AFieldOfASimulationIsInAKey(string name)
        {
            FieldInfo[] path = Leaves(typeof(FluidSimulationSettings)).Single(p => Name(p) == name);
            Assert.That(Settings().Any(_ => ChangesAKey(path)), Is.EqualTo(!ReadOtherwise.ContainsKey(name)),
                "a field belongs in FluidStartKey or FluidLiveKey, or in the list above with what reads it");
        }

        [TestCaseSource(nameof(FieldsOfProfiles))]
        public void AFieldOfAProfileReachesTheLiquid(string name)
        {
            FieldInfo[] path = Leaves(typeof(FluidProfile)).Single(p => Name(p) == name);
            string before = Shown(profile.Spec);
            bool reaches = Others(path[path.Length - 1].FieldType, Value(profile, path)).Any(v =>
            {
                Set(profile, path, v);
                return Shown(profile.Spec) != before;
            });
            Assert.That(reaches, Is.EqualTo(!NoPartOfTheLiquid.ContainsKey(name)),
                "a field belongs in FluidProfile.Spec, or in the list above");
        }

        [TestCaseSource(nameof(PropertiesOfProfiles))]
        public void ARunningLiquidSeesThatAPropertyOfItsProfileWasSet(string name)
        {
            simulation.Profile = profile;
            FluidLiveKey before = FluidLiveKey.Create(simulation.Spec);
            PropertyInfo property = typeof(FluidProfile).GetProperty(name);
            property.SetValue(profile, property.GetValue(profile));
            Assert.That(FluidLiveKey.Create(simulation.Spec).Equals(before), Is.False);
        }

        [Test]
        public void SerialisedFieldsAreFoundOneByOne() =>
            Assert.That(Leaves(typeof(Example)).Select(Name), Is.EqualTo(new[] { "kept", "part.X", "Shown" }));

        /// <summary>Settings under which each field may act: one after another, the component as it is then.</summary>
        private IEnumerable<FluidMethodKind> Settings()
        {
            foreach (FluidMethodKind method in Enum.GetValues(typeof(FluidMethodKind)))
            {
                simulation.Profile = profile;
                simulation.Method = method;
                simulation.UseSceneGravity = false;
                simulation.Gravity = new Vector3(1f, -2f, 3f);
                yield return method;
            }
            simulation.Domain = FluidDomain.Open;
            yield return simulation.Method;
        }

        private bool ChangesAKey(FieldInfo[] path)
        {
            object before = Value(simulation, path);
            FluidSpec spec = simulation.Spec;
            FluidStartKey start = FluidStartKey.Create(spec);
            FluidLiveKey live = FluidLiveKey.Create(spec);
            bool changes = Others(path[path.Length - 1].FieldType, before).Any(v =>
            {
                Set(simulation, path, v);
                FluidSpec now = simulation.Spec;
                return !FluidStartKey.Create(now).Equals(start) || !FluidLiveKey.Create(now).Equals(live);
            });
            Set(simulation, path, before);
            return changes;
        }

        private IEnumerable<object> Others(Type type, object value)
        {
            if (type == typeof(float)) return new object[] { (float)value + 0.01f, 0.5f * (float)value };
            if (type == typeof(int)) return new object[] { (int)value + 1, (int)value / 2 };
            if (type == typeof(bool)) return new object[] { !(bool)value };
            if (type == typeof(Vector3)) return new object[] { (Vector3)value + new Vector3(0.25f, 0.5f, 0.75f) };
            if (type == typeof(LayerMask)) return new object[] { (LayerMask)(((LayerMask)value).value ^ 1) };
            if (type.IsEnum) return Enum.GetValues(type).Cast<object>().Where(v => !v.Equals(value));
            if (type == typeof(FluidProfile)) return new object[] { other };
            if (type == typeof(FluidLiquid))
            {
                var packed = ScriptableObject.CreateInstance<FluidLiquid>();
                packed.StartRelaxation = FluidStartRelaxation.Packed;
                return new object[] { packed };
            }
            if (type == typeof(TextAsset)) return new object[] { new TextAsset("a start") };
            if (type == typeof(FluidShaderSet)) return new object[] { ScriptableObject.CreateInstance<FluidShaderSet>() };
            throw new NotSupportedException($"No other value of {type} is known; add one.");
        }

        /// <summary>Serialised fields, each as the fields that lead to it: those of serialised structs one by one.</summary>
        private static IEnumerable<FieldInfo[]> Leaves(Type type)
        {
            foreach (FieldInfo field in type.GetFields(Fields).OrderBy(f => f.MetadataToken))
            {
                if (!field.IsPublic && field.GetCustomAttribute<SerializeField>() == null ||
                    field.GetCustomAttribute<NonSerializedAttribute>() != null)
                {
                    continue;
                }
                bool parted = field.FieldType.IsValueType && !field.FieldType.IsEnum &&
                    (field.FieldType.Namespace ?? "").StartsWith(nameof(SphFluid));
                if (!parted) yield return new[] { field };
                else foreach (FieldInfo[] inner in Leaves(field.FieldType)) yield return new[] { field }.Concat(inner).ToArray();
            }
        }

        private static string Name(FieldInfo[] path) => string.Join(".", path.Select(f => f.Name));

        private static object Value(object owner, FieldInfo[] path) => path.Aggregate(owner, (of, field) => field.GetValue(of));

        private static void Set(object owner, FieldInfo[] path, object value)
        {
            object inner = path.Length == 1 ? value : path[0].GetValue(owner);
            if (path.Length > 1) Set(inner, path.Skip(1).ToArray(), value);
            path[0].SetValue(owner, inner);
        }

        /// <summary>All values of a spec but the count of its changes, structs in it too.</summary>
        private static string Shown(object value)
        {
            if (value == null) return "null";
            Type type = value.GetType();
            if (!type.IsValueType || type.IsPrimitive || type.IsEnum)
            {
                return value is Object asset ? asset.GetHashCode().ToString() : value is IEnumerable ? "" : value.ToString();
            }
            return string.Join(";", type.GetFields(Fields).Where(f => f.Name != nameof(ProfileSpec.Revision))
                .Select(f => Shown(f.GetValue(value))));
        }

        private sealed class Example
        {
            internal struct Part
            {
                public float X;
            }

            [SerializeField] private float kept = 0f;
            [SerializeField] private Part part = default;
            public float Shown = 0f;
            [NonSerialized] public float Now = 0f;
            private readonly float own = 0f;

            public float Sum => kept + part.X + own;
        }
    }
}
