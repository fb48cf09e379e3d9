using System;

namespace Unity.Collections.LowLevel.Unsafe;

[AttributeUsage(AttributeTargets.Field)]
public sealed class NativeDisableUnsafePtrRestrictionAttribute : Attribute { }
