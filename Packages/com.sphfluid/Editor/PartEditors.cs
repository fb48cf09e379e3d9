using UnityEditor;

namespace SphFluid.Editor
{
    /// <summary>Base of the inspectors that only name fields with their units.</summary>
    public abstract class PartEditor : UnityEditor.Editor
    {
        private protected PartEditor()
        {
        }

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            serializedObject.Update();
            FluidInspector.Draw(serializedObject);
            serializedObject.ApplyModifiedProperties();
        }
    }

    /// <summary>Inspector of emitters.</summary>
    [CustomEditor(typeof(FluidEmitter)), CanEditMultipleObjects]
    public sealed class FluidEmitterEditor : PartEditor
    {
    }

    /// <summary>Inspector of drains.</summary>
    [CustomEditor(typeof(FluidDrain)), CanEditMultipleObjects]
    public sealed class FluidDrainEditor : PartEditor
    {
    }

    /// <summary>Inspector of force zones.</summary>
    [CustomEditor(typeof(FluidForceZone)), CanEditMultipleObjects]
    public sealed class FluidForceZoneEditor : PartEditor
    {
    }

    /// <summary>Inspector of sensors.</summary>
    [CustomEditor(typeof(FluidSensor)), CanEditMultipleObjects]
    public sealed class FluidSensorEditor : PartEditor
    {
    }

    /// <summary>Inspector of a tank's glass.</summary>
    [CustomEditor(typeof(FluidTank)), CanEditMultipleObjects]
    public sealed class FluidTankEditor : PartEditor
    {
    }
}
