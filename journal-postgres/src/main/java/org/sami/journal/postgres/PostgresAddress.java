package org.sami.journal.postgres;

import java.net.URI;
import java.net.URISyntaxException;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * Where the tables of a journal, or of runs that several machines divide, are in PostgreSQL: {@code postgresql://[USER@]HOST[:PORT]/DATABASE[?PARAMETERS]}. Holds no password: the driver reads that from the user's password file, or from the one that the parameter {@code passfile} names.
 *
 * @param text as the user wrote it
 * @param schema of the tables, so that a database can hold several journals
 * @param parameters further ones of the driver
 */
public record PostgresAddress(
        String text, String host, int port, String database, String schema, Map<String, String> parameters) {
    static final String SCHEME = "postgresql";

    private static final String DEFAULT_SCHEMA = "sami";
    private static final int DEFAULT_PORT = 5432;
    private static final Pattern SCHEMA = Pattern.compile("[a-z_][a-z0-9_]{0,62}");
    private static final Pattern DATABASE = Pattern.compile("[A-Za-z0-9_.-]+");
    private static final Pattern LITERAL = Pattern.compile("127\\.\\d+\\.\\d+\\.\\d+|\\[(0*:)*:?0*1]");
    private static final Set<String> KNOWN =
            Set.of("user", "schema", "passfile", "sslmode", "sslrootcert", "sslcert", "sslkey");
    private static final Set<String> VERIFYING = Set.of("verify-full", "verify-ca");

    private static final String FORM = "an address in PostgreSQL is postgresql://HOST:PORT/DATABASE?user=NAME";
    private static final String PASSWORDS =
            "leave the password out: it would stand in lists of processes and in logs. Write the line"
                    + " HOST:PORT:DATABASE:USER:PASSWORD to ~/.pgpass (mode 600), or to the file that PGPASSFILE names";

    public PostgresAddress {
        parameters = Map.copyOf(parameters);
    }

    /**
     * Reads one.
     *
     * @throws IllegalArgumentException with a sentence for the user, which repeats no password
     */
    public static PostgresAddress parse(String text) {
        URI uri = uri(text);
        Map<String, String> parameters =
                parameters(Optional.ofNullable(uri.getRawQuery()).orElse(""));
        Optional.ofNullable(uri.getUserInfo()).ifPresent(user -> {
            if (user.contains(":")) {
                throw new IllegalArgumentException(PASSWORDS);
            }
            parameters.putIfAbsent("user", user);
        });
        String host = Optional.ofNullable(uri.getHost()).orElse("localhost");
        String path = Optional.ofNullable(uri.getPath()).orElse("");
        String database = path.startsWith("/") ? path.substring(1) : path;
        if (!DATABASE.matcher(database).matches()) {
            throw new IllegalArgumentException(FORM + ", and names a database");
        }
        String schema = Optional.ofNullable(parameters.remove("schema")).orElse(DEFAULT_SCHEMA);
        if (!SCHEMA.matcher(schema).matches()) {
            throw new IllegalArgumentException("schema is a name of small letters, digits and _, not '" + schema + "'");
        }
        int port = uri.getPort() < 0 ? DEFAULT_PORT : uri.getPort();
        PostgresAddress address = new PostgresAddress(text, host, port, database, schema, parameters);
        address.checkTls();
        return address;
    }

    private static URI uri(String text) {
        try {
            URI uri = new URI(text);
            boolean named = uri.getRawAuthority() == null || uri.getHost() != null;
            if (SCHEME.equals(uri.getScheme()) && uri.getFragment() == null && named) {
                return uri;
            }
            throw new IllegalArgumentException(FORM);
        } catch (URISyntaxException unreadable) {
            throw new IllegalArgumentException(FORM); // without the text, which may hold a password
        }
    }

    private static Map<String, String> parameters(String query) {
        Map<String, String> parameters = new LinkedHashMap<>();
        for (String part : query.isEmpty() ? new String[0] : query.split("&", -1)) {
            int equal = part.indexOf('=');
            String name = equal < 0 ? part : part.substring(0, equal);
            if (name.toLowerCase(Locale.ROOT).contains("password")) {
                throw new IllegalArgumentException(PASSWORDS);
            }
            if (equal < 0 || !KNOWN.contains(name)) {
                throw new IllegalArgumentException(
                        FORM + "; its parameters are user, schema, passfile, sslmode, sslrootcert,"
                                + " sslcert and sslkey, each with = and a value");
            }
            parameters.put(name, URLDecoder.decode(part.substring(equal + 1), StandardCharsets.UTF_8));
        }
        return parameters;
    }

    private void checkTls() {
        String mode = parameters.get("sslmode");
        if (mode != null && !isLoopback() && !VERIFYING.contains(mode)) {
            throw new IllegalArgumentException("sslmode=" + mode + " is for this machine alone: to " + host
                    + " data goes by TLS with the server's certificate checked, verify-full (the default) or"
                    + " verify-ca");
        }
    }

    /** Whether the database is on this machine, by its name. */
    public boolean isLoopback() {
        return host.equals("localhost") || LITERAL.matcher(host).matches();
    }

    /** The driver's address. */
    public String url() {
        return "jdbc:postgresql://" + host + ":" + port + "/" + database;
    }

    /** What the driver is to do. Holds a password only where the address names a file of passwords: the driver itself knows one such file for the whole process. */
    public Properties properties() {
        Properties properties = new Properties();
        properties.setProperty("sslmode", isLoopback() ? "prefer" : "verify-full");
        parameters.forEach(properties::setProperty);
        if (properties.remove("passfile") instanceof String file) {
            PasswordFile.password(Path.of(file), host, port, database, parameters.getOrDefault("user", ""))
                    .ifPresent(password -> properties.setProperty("password", password));
        }
        if ("system".equals(parameters.get("sslrootcert"))) {
            properties.remove("sslrootcert");
            properties.setProperty("sslfactory", "org.postgresql.ssl.DefaultJavaSSLFactory");
        }
        properties.setProperty("currentSchema", schema);
        return properties;
    }

    /** For messages: database, host and schema. */
    public String words() {
        return SCHEME + "://" + host + ":" + port + "/" + database
                + (schema.equals(DEFAULT_SCHEMA) ? "" : "?schema=" + schema);
    }
}
