using UnityEngine;

namespace Headless.Engine;

/// <summary>A draw that a camera or light sees, with its sorting keys.</summary>
internal readonly record struct VisibleDraw(DrawRequest Request, int Queue, float Distance, int Order);
