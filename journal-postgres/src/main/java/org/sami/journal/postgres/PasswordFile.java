package org.sami.journal.postgres;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Pattern;

/** A file of passwords as PostgreSQL's programs read it: lines of {@code HOST:PORT:DATABASE:USER:PASSWORD}, where {@code *} stands for any. Escaped characters are not known here. */
final class PasswordFile {
    private static final Pattern COLON = Pattern.compile(":");
    private static final int FIELDS = 5;

    private PasswordFile() {}

    /** The password of the first line that fits; empty where none does, or the file cannot be read. */
    static Optional<String> password(Path file, String host, int port, String database, String user) {
        try {
            String[] wanted = {host, Integer.toString(port), database, user};
            return Files.readAllLines(file).stream()
                    .map(line -> COLON.split(line, FIELDS))
                    .filter(fields -> fields.length == FIELDS && fits(fields, wanted))
                    .map(fields -> fields[FIELDS - 1])
                    .findFirst();
        } catch (IOException unreadable) {
            return Optional.empty(); // the database says then that no password was given
        }
    }

    private static boolean fits(String[] fields, String[] wanted) {
        for (int each = 0; each < wanted.length; each++) {
            if (!fields[each].equals("*") && !fields[each].equals(wanted[each])) {
                return false;
            }
        }
        return true;
    }
}
