package org.sami.pair.postgres;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** PostgreSQL's list of who may connect to a database of a pair: this machine's programs, and both bases by TLS. Both databases have the same one. */
final class AccessList {
    private static final Pattern IPV4 = Pattern.compile("(\\d{1,3}\\.){3}\\d{1,3}");
    private static final String SESSIONS = "hostssl " + Roles.DATABASE + " " + Roles.SESSION + " ";
    private static final String REPLICAS = "hostssl replication " + Roles.REPLICA + " ";
    private static final String BY_PASSWORD = " scram-sha-256";

    private final Path file;

    /** The list of the database in a folder of its own. */
    AccessList(Path data) {
        file = data.resolve("pg_hba.conf");
    }

    /** Writes it for a new database. */
    void write(PairSettings settings) throws IOException {
        List<String> lines = new ArrayList<>(List.of(
                "# Of a pair of bases (SAMI)",
                "host all all 127.0.0.0/8" + BY_PASSWORD,
                "host replication " + Roles.REPLICA + " 127.0.0.0/8" + BY_PASSWORD));
        addBases(lines, settings);
        PrivateFile.write(file, text(lines));
    }

    /** Lets both bases in at their present addresses, and no longer at earlier ones. What else a person wrote there stays. */
    void replace(PairSettings settings) throws IOException {
        List<String> lines = new ArrayList<>(Files.readAllLines(file));
        lines.removeIf(line -> line.startsWith(SESSIONS) || line.startsWith(REPLICAS));
        addBases(lines, settings);
        PrivateFile.write(file, text(lines));
    }

    private static void addBases(List<String> lines, PairSettings settings) {
        for (String host : List.of(settings.here(), settings.other())) {
            lines.add(SESSIONS + machine(host) + BY_PASSWORD);
            lines.add(REPLICAS + machine(host) + BY_PASSWORD);
        }
    }

    private static String text(List<String> lines) {
        return String.join("\n", lines) + "\n";
    }

    /** How the list names a machine. */
    static String machine(String host) {
        if (host.contains(":")) {
            return host + "/128";
        }
        return IPV4.matcher(host).matches() ? host + "/32" : host;
    }
}
