namespace Headless.Engine;

/// <summary>What is behind a RendererList.</summary>
internal abstract class RendererListContent(ContextCommands owner)
{
    public bool IsExpired => owner.IsOver;

    public abstract bool IsEmpty { get; }

    /// <summary>Finds and sorts what it draws, if that is still to do.</summary>
    public virtual void Prepare()
    {
    }

    public abstract void Draw();
}
