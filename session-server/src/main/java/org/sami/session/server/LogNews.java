package org.sami.session.server;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.function.LongSupplier;
import org.sami.session.person.Person;

/** Notes in the operator's log who fetches the logs of which boat: once, however often a broken link has them asked for again. Safe for use by several threads. */
final class LogNews {
    private static final long SAME_FETCH_NANOS = TimeUnit.MINUTES.toNanos(10);

    private final PeopleNews news;
    private final LongSupplier nanos;
    private final Map<String, Long> fetched = new HashMap<>(); // guarded by this; who and which boat, when last

    LogNews(PeopleNews news, LongSupplier nanos) {
        this.news = news;
        this.nanos = nanos;
    }

    /** A person asks for the logs of a boat to which there is a link. */
    void fetches(Person person, String boat) {
        long now = nanos.getAsLong();
        Long last;
        synchronized (this) {
            fetched.values().removeIf(at -> now - at > SAME_FETCH_NANOS);
            last = fetched.put(person.name() + " " + boat, now);
        }
        if (last == null) {
            news.tell(person.name(), "fetches the logs of " + boat);
        }
    }
}
