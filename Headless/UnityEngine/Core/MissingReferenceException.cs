using System;

namespace UnityEngine;

[Serializable]
public class MissingReferenceException : SystemException
{
    public MissingReferenceException() : base("A Unity Runtime error occurred!") { }
    public MissingReferenceException(string message) : base(message) { }
    public MissingReferenceException(string message, Exception innerException) : base(message, innerException) { }
}
