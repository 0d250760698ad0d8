package org.sami.spn.journal;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import org.sami.spn.host.JournalException;

/**
 * What a journal's file may consist of: the tables of journals, with plain columns. A file that somebody else has made may have views, triggers or
 * computed columns in their place, and SQLite would run what stands in them.
 */
final class JournalSchema {
    private static final Set<String> TABLES =
            Set.of("header", "entries", "snapshots", "marks", "telemetry", "documents");
    private static final Pattern COMPUTED =
            Pattern.compile("\\b(check|generated|as|default|references|collate|select)\\b", Pattern.CASE_INSENSITIVE);

    private JournalSchema() {}

    /**
     * Refuses a file with anything else in it.
     *
     * @throws JournalException that names what it is
     */
    static void check(Path file, Connection connection) throws JournalException, SQLException {
        try (Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery("SELECT type, name, tbl_name, sql FROM sqlite_master")) {
            while (rows.next()) {
                String type = rows.getString(1);
                String name = rows.getString(2);
                if (!isOurs(type, name, rows.getString(3), rows.getString(4))) {
                    throw new JournalException(
                            file, 0, "is none that this program wrote: it has a " + words(type, name));
                }
            }
        }
    }

    private static boolean isOurs(String type, String name, String table, String sql) {
        if (type == null || name == null || table == null) {
            return false;
        }
        return switch (type) {
            case "table" -> TABLES.contains(name) && isPlain(name, sql);
            case "index" -> TABLES.contains(table) && sql == null && name.startsWith("sqlite_autoindex_");
            default -> false;
        };
    }

    private static boolean isPlain(String name, String sql) {
        if (sql == null) {
            return false;
        }
        String begins = "create table " + name;
        return sql.toLowerCase(Locale.ROOT).startsWith(begins)
                && !COMPUTED.matcher(sql.substring(begins.length())).find();
    }

    private static String words(String type, String name) {
        String shown = String.valueOf(name)
                .codePoints()
                .limit(60)
                .collect(
                        StringBuilder::new,
                        (text, letter) -> text.appendCodePoint(Character.isISOControl(letter) ? '?' : letter),
                        StringBuilder::append)
                .toString();
        String kind = "table".equals(type) && TABLES.contains(name) ? "table that computes" : String.valueOf(type);
        return kind + " named " + shown;
    }
}
