package org.sami.dreamm.file;

import java.nio.file.Path;
import java.time.Instant;
import java.util.Optional;

/**
 * A project with changes that a process that is gone has left behind.
 *
 * @param folder where it lies
 * @param project its document
 * @param file where the project would have been saved; empty where it had no file yet
 * @param time when it was kept
 */
public record UnsavedWork(Path folder, Path project, Optional<Path> file, Instant time) {}
