package org.sami.crw.cli.pair;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The clock of a laptop that is off: what is run by it sees another date and time. How long the machine has been on stays the same. */
final class OtherClock {
    private static final Path LIBRARIES = Path.of("/usr/lib");
    private static final Path LIBRARY = Path.of("faketime", "libfaketimeMT.so.1");

    private final String offset;
    private final Path library;

    private OtherClock(String offset, Path library) {
        this.offset = offset;
        this.library = library;
    }

    /**
     * A clock that is off.
     *
     * @param offset how much, as libfaketime takes it, such as {@code +1d}
     */
    static OtherClock off(String offset) throws IOException {
        Optional<Path> library = library();
        assumeTrue(library.isPresent(), "another clock needs libfaketime: sudo apt install libfaketime");
        return new OtherClock(offset, library.orElseThrow());
    }

    private static Optional<Path> library() throws IOException {
        try (Stream<Path> architectures = Files.list(LIBRARIES)) {
            return architectures
                    .map(architecture -> architecture.resolve(LIBRARY))
                    .filter(Files::exists)
                    .findFirst();
        }
    }

    /** The command that runs others by this clock, with all that they start. */
    List<String> command() {
        return List.of("env", "LD_PRELOAD=" + library, "FAKETIME=" + offset, "DONT_FAKE_MONOTONIC=1");
    }
}
