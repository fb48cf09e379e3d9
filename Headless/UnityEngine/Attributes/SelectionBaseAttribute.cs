using System;

namespace UnityEngine;

[AttributeUsage(AttributeTargets.Class, Inherited = true)]
public class SelectionBaseAttribute : Attribute { }
