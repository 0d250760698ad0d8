package org.sami.boat.app.boat;

import java.io.IOException;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.regex.Pattern;
import org.sami.boat.server.BoatServerDefaults;

/** Name and port of the boat on a phone, and the size of its log, kept over all starts and versions of the app. Immutable. */
public final class PhoneSettings {
    /** The port of a boat that was not given another. */
    public static final int USUAL_PORT = 11411;

    /** Least port: those below are the system's. */
    public static final int LEAST_PORT = 1024;

    /** Highest port. */
    public static final int MOST_PORT = 65_535;

    /** Size of a log in MiB that was not given another. */
    public static final int USUAL_LOG_MEBIBYTES = (int) (BoatServerDefaults.LOG_BYTES >> 20);

    /** Largest log in MiB. */
    public static final int MOST_LOG_MEBIBYTES = 512;

    private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9_-]{0,39}");
    private static final Pattern TEXT = Pattern.compile("name=(.*)\nport=(\\d{1,9})\n(?:log=(\\d{1,9})\n)?");

    private final String name;
    private final int port;
    private final int logMebibytes;

    /**
     * Name and port, and a log of the usual size.
     *
     * @param name 1 to 40 letters, digits, {@code -} and {@code _}; unique in the fleet
     * @throws IllegalArgumentException that says what is wrong, in words for people
     */
    public PhoneSettings(String name, int port) {
        this(name, port, USUAL_LOG_MEBIBYTES);
    }

    /**
     * Name, port and size of the log.
     *
     * @param name 1 to 40 letters, digits, {@code -} and {@code _}; unique in the fleet
     * @param logMebibytes most MiB of all files of the log together
     * @throws IllegalArgumentException that says what is wrong, in words for people
     */
    public PhoneSettings(String name, int port, int logMebibytes) {
        if (!NAME.matcher(name).matches()) {
            throw new IllegalArgumentException(
                    "a name has 1 to 40 letters, digits, - and _, a letter or digit first; '" + name + "' has not");
        }
        if (port < LEAST_PORT || port > MOST_PORT) {
            throw new IllegalArgumentException("a port is " + LEAST_PORT + " to " + MOST_PORT + ", not " + port);
        }
        if (logMebibytes < 1 || logMebibytes > MOST_LOG_MEBIBYTES) {
            throw new IllegalArgumentException("a log has 1 to " + MOST_LOG_MEBIBYTES + " MiB, not " + logMebibytes);
        }
        this.name = name;
        this.port = port;
        this.logMebibytes = logMebibytes;
    }

    /**
     * Reads the settings. At the first start it makes a name and writes it, so that the boat has the same one ever after.
     *
     * @throws IOException if the file cannot be read or written, or is damaged: another name would be another boat
     */
    public static PhoneSettings readOrMake(AppFiles files, Random random) throws IOException {
        Optional<String> text = AppFiles.text(files.settings());
        if (!text.isPresent()) {
            PhoneSettings made =
                    new PhoneSettings(String.format(Locale.ROOT, "boat-%04x", random.nextInt(0x10000)), USUAL_PORT);
            made.write(files);
            return made;
        }
        java.util.regex.Matcher read = TEXT.matcher(text.get());
        try {
            if (read.matches()) {
                int log = read.group(3) == null ? USUAL_LOG_MEBIBYTES : Integer.parseInt(read.group(3));
                return new PhoneSettings(read.group(1), Integer.parseInt(read.group(2)), log);
            }
        } catch (IllegalArgumentException e) {
            throw new IOException(files.settings() + ": " + e.getMessage(), e);
        }
        throw new IOException(files.settings() + ": expected are the lines name=..., port=... and maybe log=...");
    }

    /** Keeps them. */
    public void write(AppFiles files) throws IOException {
        AppFiles.write(files.settings(), "name=" + name + "\nport=" + port + "\nlog=" + logMebibytes + "\n");
    }

    /** Names the boat. */
    public String name() {
        return name;
    }

    /** The TCP port of its server. */
    public int port() {
        return port;
    }

    /** Most MiB of all files of its log together. */
    public int logMebibytes() {
        return logMebibytes;
    }

    /** Most bytes of its log. */
    long logBytes() {
        return (long) logMebibytes << 20;
    }

    /** Whether nothing differs. */
    public boolean isSame(PhoneSettings other) {
        return name.equals(other.name) && port == other.port && logMebibytes == other.logMebibytes;
    }
}
