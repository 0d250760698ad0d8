package org.sami.work.postgres.testing;

import io.zonky.test.db.postgres.embedded.EmbeddedPostgres;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import org.sami.journal.postgres.PostgresAddress;

/** A PostgreSQL server for tests; each test has a schema of its own in it. It ends with the process. */
public final class TestDatabase {
    private static final AtomicInteger SCHEMAS = new AtomicInteger();

    private TestDatabase() {}

    private static final class Shared {
        static final EmbeddedPostgres SERVER = start();
    }

    private static EmbeddedPostgres start() {
        try {
            return EmbeddedPostgres.builder()
                    .setOverrideWorkingDirectory(
                            Path.of("build", "postgres").toAbsolutePath().toFile())
                    .setPGStartupWait(Duration.ofMinutes(2))
                    .start();
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }

    /** A schema that is not there yet. */
    public static PostgresAddress address() {
        return PostgresAddress.parse("postgresql://localhost:" + Shared.SERVER.getPort()
                + "/postgres?user=postgres&schema=w" + SCHEMAS.incrementAndGet());
    }

    /** Does something to tables as another program would. */
    public static void run(PostgresAddress address, String sql) throws SQLException {
        try (Connection connection = DriverManager.getConnection(address.url(), address.properties());
                Statement statement = connection.createStatement()) {
            statement.execute(sql);
        }
    }

    /** A number that a query gives. */
    public static long number(PostgresAddress address, String sql) throws SQLException {
        try (Connection connection = DriverManager.getConnection(address.url(), address.properties());
                Statement statement = connection.createStatement();
                ResultSet rows = statement.executeQuery(sql)) {
            rows.next();
            return rows.getLong(1);
        }
    }
}
