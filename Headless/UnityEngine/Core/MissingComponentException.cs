using System;

namespace UnityEngine;

[Serializable]
public class MissingComponentException : SystemException
{
    public MissingComponentException() : base("A Unity Runtime error occurred!") { }
    public MissingComponentException(string message) : base(message) { }
    public MissingComponentException(string message, Exception innerException) : base(message, innerException) { }
}
