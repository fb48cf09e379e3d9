namespace UnityEngine;

public class Behaviour : Component
{
    bool m_Enabled = true;

    public bool enabled
    {
        get { CheckAlive(); return m_Enabled; }
        set
        {
            CheckAlive();
            if (m_Enabled == value) return;
            m_Enabled = value;
            RefreshActivation();
        }
    }

    public bool isActiveAndEnabled => IsAlive && m_Enabled && OwnerOrNull is { IsActiveCached: true };

    internal override bool EnabledSelf => m_Enabled;
    internal void SetEnabledRaw(bool value) => m_Enabled = value;

    internal override void CopyNativeState(Component source, Headless.Engine.Cloner cloner)
    {
        m_Enabled = ((Behaviour)source).m_Enabled;
        base.CopyNativeState(source, cloner);
    }
}
