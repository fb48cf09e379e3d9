using System;
using System.Linq;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Editor
{
    /// <summary>An undoable cure for a message.</summary>
    public readonly struct FluidFix
    {
        private readonly Action action;

        private FluidFix(string label, Action action)
        {
            Label = label;
            this.action = action;
        }

        /// <summary>Text of the button.</summary>
        public string Label { get; }

        /// <summary>Applies the cure as one undo step; an import setting is changed on disk instead.</summary>
        public void Apply() => action();

        /// <summary>The cure for a message.</summary>
        /// <param name="message">The message.</param>
        /// <param name="simulation">Simulation that was checked.</param>
        /// <returns>Null when only the user can decide.</returns>
        public static FluidFix? For(in FluidMessage message, FluidSimulation simulation)
        {
            Object context = message.Context;
            switch (message.Issue)
            {
                case FluidIssue.ProfileMissing when simulation.ActiveLiquid == null && PackageAssets.Liquid("Water") != null:
                    return Change(simulation, "Use Water", () => simulation.Liquid = PackageAssets.Liquid("Water"));
                case FluidIssue.LiquidOverridden when context is FluidSurfaceRenderer view:
                    return Change(view, "Switch Own Look Off", () => view.OwnLook = false);
                case FluidIssue.LiquidOverridden:
                    return Change(simulation, "Clear Profile", () => simulation.Profile = null);
                case FluidIssue.LiquidsDiffer when context is FluidEmitter emitter && simulation.ActiveLiquid != null:
                    return Change(emitter, $"Use {simulation.ActiveLiquid.name}", () => emitter.Liquid = simulation.ActiveLiquid);
                case FluidIssue.ShadersMissing when context is FluidProfile profile && PackageAssets.Shaders != null:
                    return Change(profile, "Use Package Shaders", () => profile.Shaders = PackageAssets.Shaders);
                case FluidIssue.ShadersMissing when context is FluidShaderSet set && PackageAssets.Shaders != null &&
                    set != PackageAssets.Shaders:
                    return Change(set, "Use Package Shaders", () => EditorUtility.CopySerializedIfDifferent(PackageAssets.Shaders, set));
                case FluidIssue.TransformScaled:
                    return UnitScale(simulation);
                case FluidIssue.DomainSizeInvalid:
                    return Change(simulation, "Make Positive", () => simulation.DomainSize = Positive(simulation.DomainSize));
                case FluidIssue.SpacingInvalid:
                    return Change(simulation, "Fit Spacing", () => simulation.Spacing = FittingSpacing(simulation));
                case FluidIssue.TimeStepInvalid:
                    return Change(simulation, "Use Automatic", () => simulation.TimeStepMode = FluidTimeStepMode.Automatic);
                case FluidIssue.BoundariesInvalid when simulation.Domain == FluidDomain.Open &&
                    BoundaryChecks.FacesAreWrong(simulation.Spec):
                    return Change(simulation, "Use a Box", () => simulation.Domain = FluidDomain.Box);
                case FluidIssue.BoundariesInvalid when BoundaryChecks.FacesAreWrong(simulation.Spec):
                    return Change(simulation, "Use Plain Walls", () => simulation.Boundaries = default);
                case FluidIssue.BoundariesInvalid:
                    return Change(simulation, "Remove Body Force", () => simulation.BodyForce = default);
                case FluidIssue.NoLiquid:
                    return new FluidFix("Add Liquid", () => FluidMenu.AddVolume(simulation));
                case FluidIssue.NotDrawn:
                    return new FluidFix("Draw Surface", () => Undo.AddComponent<FluidSurfaceRenderer>(simulation.gameObject));
                case FluidIssue.TooManyParticles when simulation.Profile != null:
                    return Change(simulation, "Coarsen Spacing", () => Coarsen(simulation));
                case FluidIssue.TooManyCells:
                    return Change(simulation, "Coarsen Spacing", () => simulation.Spacing = CellChecks.FittingSpacing(simulation.Spec));
                case FluidIssue.MethodChoice when message.Severity == FluidSeverity.Warning &&
                    message.Cure.StartsWith(MethodChoiceText.SpacingCure, StringComparison.Ordinal):
                    return Change(simulation, "Coarsen Spacing", () => CoarsenForBudget(simulation));
                case FluidIssue.VolumeSizeInvalid when context is FluidVolume volume && !(Smallest(volume.Size) > 0f):
                    return Change(volume, "Make Positive", () => volume.Size = Positive(volume.Size));
                case FluidIssue.VolumeChanged when Application.isPlaying:
                    return new FluidFix("Restart", () => simulation.ResetSimulation());
                case FluidIssue.MeshNotReadable when context is MeshCollider collider:
                    return MakeReadable(collider.sharedMesh);
                default:
                    return null;
            }
        }

        private static FluidFix Change(Object target, string label, Action change) => new FluidFix(label, () =>
        {
            Undo.RecordObject(target, label);
            change();
            EditorUtility.SetDirty(target);
            PrefabUtility.RecordPrefabInstancePropertyModifications(target);
        });

        private static FluidFix? UnitScale(FluidSimulation simulation)
        {
            Transform transform = simulation.transform;
            return ScaleForOne(transform) is Vector3 scale ? Change(transform, "Set Scale to 1", () => transform.localScale = scale)
                : (FluidFix?)null;
        }

        /// <summary>
        /// The local scale with which an object has scale 1 in the world; null where its parents allow none. A scaled parent is not ours to
        /// change.
        /// </summary>
        internal static Vector3? ScaleForOne(Transform transform)
        {
            Vector3 parent = transform.parent != null ? transform.parent.lossyScale : Vector3.one;
            bool allows = Smallest(new Vector3(Mathf.Abs(parent.x), Mathf.Abs(parent.y), Mathf.Abs(parent.z))) > 0f;
            return allows ? new Vector3(1f / parent.x, 1f / parent.y, 1f / parent.z) : (Vector3?)null;
        }

        private static FluidFix? MakeReadable(Mesh mesh)
        {
            if (!(AssetImporter.GetAtPath(AssetDatabase.GetAssetPath(mesh)) is ModelImporter importer)) return null;
            return new FluidFix("Enable Read/Write", () =>
            {
                importer.isReadable = true;
                importer.SaveAndReimport();
            });
        }

        // Layers come and go whole, so the fitted spacing may still be a few particles above the cap.
        private static void Coarsen(FluidSimulation simulation)
        {
            simulation.Spacing = simulation.SpacingForParticleCount(simulation.Profile.MaxParticles);
            for (int i = 0; i < 50 && simulation.Validate().Any(m => m.Issue == FluidIssue.TooManyParticles); i++)
            {
                simulation.Spacing *= 1.01f;
            }
        }

        private static void CoarsenForBudget(FluidSimulation simulation)
        {
            if (FluidSimulationChecks.PreviewChoice(simulation) is FluidMethodChoice choice && choice.ProposedSpacing > 0f)
            {
                simulation.Spacing = choice.ProposedSpacing;
            }
        }

        private static float FittingSpacing(FluidSimulation simulation)
        {
            Vector3 size = Positive(simulation.DomainSize);
            return Smallest(size) / 40f;
        }

        private static Vector3 Positive(Vector3 size) => new Vector3(Positive(size.x), Positive(size.y), Positive(size.z));

        private static float Positive(float value) => value < 0f && !float.IsInfinity(value) ? -value : value > 0f &&
            !float.IsInfinity(value) ? value : 1f;

        private static float Smallest(Vector3 v) => Mathf.Min(v.x, Mathf.Min(v.y, v.z));
    }
}
