package org.sami.session.client.testing;

import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.sami.session.client.PersonRights;
import org.sami.session.client.RemoteListener;
import org.sami.session.client.SessionAddress;

/** What a front is told of its connection and of other people, as lines in their order. Safe for use by several threads. */
public final class FrontNotices implements RemoteListener {
    private static final int WITHIN_MIN = 15; // a machine may stand still for long

    private final BlockingQueue<String> lines = new LinkedBlockingQueue<>();

    /** The next line; waits for it. */
    public String next() throws InterruptedException {
        return Optional.ofNullable(lines.poll(WITHIN_MIN, TimeUnit.MINUTES)).orElseThrow();
    }

    /** The next line that begins so; lines before it are passed over. */
    public String next(String beginning) throws InterruptedException {
        String line = next();
        while (!line.startsWith(beginning)) {
            line = next();
        }
        return line;
    }

    @Override
    public void lost(String words) {
        lines.add(words);
    }

    @Override
    public void back(SessionAddress base) {
        lines.add("back at " + base);
    }

    @Override
    public void ended(String why) {
        lines.add("ended: " + why);
    }

    @Override
    public void rights(PersonRights now) {
        lines.add("role: " + now.role());
    }

    @Override
    public void news(String text) {
        lines.add(text);
    }
}
