using System;
using System.Collections;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>An enumerator that is gone through a frame at a time; where it yields another one, that one comes first.</summary>
    public sealed class SessionWork
    {
        private readonly Stack<IEnumerator> work = new Stack<IEnumerator>();

        /// <summary>Work that has not begun.</summary>
        public SessionWork(IEnumerator root) => work.Push(root);

        /// <summary>Whether there is nothing left.</summary>
        public bool IsDone => work.Count == 0;

        /// <summary>Goes on until a frame of the engine has to go by.</summary>
        /// <returns>False when there is nothing left.</returns>
        public bool Step()
        {
            while (work.Count > 0)
            {
                if (!work.Peek().MoveNext())
                    work.Pop();
                else if (work.Peek().Current is IEnumerator inner)
                    work.Push(inner);
                else
                    return true;
            }
            return false;
        }

        /// <summary>Goes on to the end, without frames between.</summary>
        public void Finish()
        {
            while (Step())
            {
            }
        }

        /// <summary>Gives up what is left; what it holds in using blocks is freed.</summary>
        public void Clear()
        {
            while (work.Count > 0) (work.Pop() as IDisposable)?.Dispose();
        }
    }
}
