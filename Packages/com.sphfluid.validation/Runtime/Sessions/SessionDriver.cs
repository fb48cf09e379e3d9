using System;
using System.IO;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Runs a measurement in play mode, a step a frame, and ends the program with it.</summary>
    [AddComponentMenu("")]
    internal sealed class SessionDriver : MonoBehaviour
    {
        private const int FailureExitCode = 1;

        private IValidationSession session;

        public static void Begin(IValidationSession session)
        {
            var holder = new GameObject(session.GetType().Name) { hideFlags = HideFlags.HideAndDontSave };
            holder.AddComponent<SessionDriver>().session = session;
        }

        private void Update()
        {
            try
            {
                if (!session.Step()) Application.Quit(0);
            }
            catch (Exception exception) when (IsExpected(exception))
            {
                Console.Error.WriteLine(exception.Message);
                Application.Quit(FailureExitCode);
            }
            catch
            {
                Application.Quit(FailureExitCode);
                throw;
            }
        }

        private void OnDestroy() => session?.Dispose();

        /// <summary>
        /// What a device, a disk or shards that lack runs can do to a measurement; the message is all that the user needs.
        /// </summary>
        public static bool IsExpected(Exception exception) =>
            exception is FluidDeviceException || exception is IncompleteException || exception is IOException ||
                exception is UnauthorizedAccessException;
    }
}
