package org.sami.journal.postgres;

import java.io.IOException;
import java.sql.SQLException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import java.util.stream.LongStream;
import org.sami.spn.host.JournalEntry;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.journal.JournalOptions;
import org.sami.spn.protocol.Input;

/** Bases with journals for tests. Their leases last for hours, so that none ends because the machine stands still; tests end them. */
final class Journals {
    static final JournalHeader HEADER =
            JournalHeader.of("the plans", Map.of("domain.json", "its wörds"), Map.of("kind", "session"));

    private Journals() {}

    static final Duration OWN_LIMIT = Duration.ofHours(1);

    /** A base that does not renew its lease by itself during a test. */
    static PostgresStore base(String name) {
        return base(name, OWN_LIMIT, System::nanoTime);
    }

    /** A base with another clock, which renews its lease so often. */
    static PostgresStore base(String name, Duration renewEvery, LongSupplier nanos) {
        return new PostgresStore(new LeaseTerms(Duration.ofHours(2), renewEvery, OWN_LIMIT), name, nanos);
    }

    static PostgresJournal create(String name, String address) throws IOException {
        return (PostgresJournal) base(name).create(address, HEADER, JournalOptions.DEFAULT);
    }

    /** Entries that follow an index; each a second after the one before. */
    static List<JournalEntry> entries(long after, int count) {
        return LongStream.rangeClosed(after + 1, after + count)
                .mapToObj(index -> new JournalEntry(index, index * 1000, new Input.ProxyJoined("boat-ä" + index)))
                .toList();
    }

    /** Has the lease of an address end now, by the database's clock. */
    static void endLease(String address) throws SQLException {
        TestServer.run(address, "UPDATE lease SET ends = clock_timestamp()");
    }
}
