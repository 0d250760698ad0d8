package org.sami.crw.cli.output;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/** Standard output and standard error of this process. */
public final class StandardStreams {
    private StandardStreams() {}

    /**
     * Has both write UTF-8 where the locale knows ASCII only ({@code LC_ALL=C}): a name with an umlaut would be printed with a
     * question mark. Another encoding stays, for a terminal has it too. Comes before the command line is built, which keeps the
     * streams that it finds.
     */
    public static void speakUtf8() {
        String system = System.getProperty("native.encoding", "UTF-8");
        if (Charset.isSupported(system) && Charset.forName(system).equals(StandardCharsets.US_ASCII)) {
            System.setOut(stream(FileDescriptor.out));
            System.setErr(stream(FileDescriptor.err));
            System.setProperty("sun.stdout.encoding", "UTF-8"); // picocli's writers ask for it
            System.setProperty("sun.stderr.encoding", "UTF-8");
        }
    }

    private static PrintStream stream(FileDescriptor descriptor) {
        return new PrintStream(new FileOutputStream(descriptor), true, StandardCharsets.UTF_8);
    }
}
