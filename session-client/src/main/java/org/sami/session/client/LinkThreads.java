package org.sami.session.client;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;

/** The threads of a session that runs elsewhere, which keep no program alive: one has its link and its copy, one finds ways on the map. */
final class LinkThreads {
    private static final int END_S = 2;

    private final ScheduledExecutorService link = Executors.newSingleThreadScheduledExecutor(named("session link"));
    private final ExecutorService map = Executors.newSingleThreadExecutor(named("map"));

    private static ThreadFactory named(String name) {
        return work -> {
            Thread one = new Thread(work, name);
            one.setDaemon(true);
            return one;
        };
    }

    /** Has the link, and the copy of the session that follows it. */
    ScheduledExecutorService link() {
        return link;
    }

    /** Has what takes long to compute. */
    ExecutorService map() {
        return map;
    }

    /** Does one thing more on the link's thread, and waits for it for two seconds at most. */
    void end(Runnable last) {
        link.execute(last);
        link.shutdown();
        map.shutdown();
        try {
            if (!link.awaitTermination(END_S, TimeUnit.SECONDS)) {
                link.shutdownNow();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
