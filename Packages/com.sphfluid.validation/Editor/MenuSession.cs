using System;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Validation.Editor
{
    /// <summary>A measurement that a menu command starts and stops; it goes on while the Editor is used.</summary>
    internal sealed class MenuSession
    {
        private readonly Func<SessionProgress, IValidationSession> create;
        private IValidationSession session;

        public MenuSession(Func<SessionProgress, IValidationSession> create) => this.create = create;

        public void Toggle()
        {
            if (session != null)
            {
                End();
                return;
            }
            try
            {
                session = create(new SessionProgress(text => Debug.Log($"{FluidMessage.Prefix} {text}"), null));
                EditorApplication.update += Step;
            }
            catch (Exception exception) when (exception is CommandLineException || SessionDriver.IsExpected(exception))
            {
                Debug.LogError($"{FluidMessage.Prefix} {exception.Message}");
            }
        }

        private void Step()
        {
            try
            {
                if (!session.Step()) End();
            }
            catch (Exception exception)
            {
                Debug.LogException(exception);
                End();
            }
        }

        private void End()
        {
            EditorApplication.update -= Step;
            session.Dispose();
            session = null;
        }
    }
}
