package org.sami.session.client;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.boat.link.security.OwnerOnlyFile;

/** The servers of sessions whose certificates somebody has compared, in a file of this user: a line for each, {@code HOST:PORT SHA-256}. Safe for use by several threads. */
public final class KnownServers {
    private final Path file;

    /** Servers in a file, which need not exist yet. */
    public KnownServers(Path file) {
        this.file = file;
    }

    /** The file. */
    public Path file() {
        return file;
    }

    /**
     * The SHA-256 of a server's certificate, as it prints it; empty for a server that is not known.
     *
     * @throws IOException if the file cannot be read, or may be read by others
     */
    synchronized Optional<String> certificate(String authority) throws IOException {
        return Optional.ofNullable(all().get(authority));
    }

    /**
     * Notes that a certificate was compared.
     *
     * @throws IOException if the file cannot be read or written
     */
    synchronized void add(String authority, String certificate) throws IOException {
        Map<String, String> all = all();
        all.put(authority, certificate);
        StringBuilder text = new StringBuilder();
        all.forEach(
                (server, print) -> text.append(server).append(' ').append(print).append('\n'));
        OwnerOnlyFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    private Map<String, String> all() throws IOException {
        Map<String, String> all = new TreeMap<>();
        if (Files.exists(file)) {
            for (String line : new String(OwnerOnlyFile.read(file), StandardCharsets.UTF_8).split("\n")) {
                String[] words = line.strip().split(" ");
                if (words.length != 2 && !line.isBlank()) {
                    throw new IOException(file + " is damaged: '" + line + "' is not HOST:PORT and a SHA-256");
                } else if (words.length == 2) {
                    all.put(words[0], words[1]);
                }
            }
        }
        return all;
    }
}
