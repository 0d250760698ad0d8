package org.sami.boat.link.security;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.boat.link.Role;

/**
 * The own key of a boat or base, the peers that are paired with it, and the keys that were withdrawn. Changes are kept before they count. Safe for use by
 * several threads.
 */
public final class KeyRing {
    private static final int MOST_PEERS = 1000;

    /** Keeps what has changed. */
    public interface Keeper {
        /** Keeps nothing beyond the process. */
        Keeper NONE = next -> {};

        /** Keeps the content in place of the earlier one. */
        void keep(Content next) throws IOException;
    }

    private final Identity identity;
    private final Keeper keeper;
    private volatile Content content;

    KeyRing(Identity identity, Content content, Keeper keeper) {
        this.identity = identity;
        this.content = content;
        this.keeper = keeper;
    }

    /** Keys that last as long as the process. */
    public static KeyRing inMemory() {
        return new KeyRing(Identity.generate(), Content.EMPTY, Keeper.NONE);
    }

    /** The own key. */
    public Identity identity() {
        return identity;
    }

    /** The peers, in the order in which they were paired. */
    public List<Peer> peers() {
        return new ArrayList<>(content.peers.values());
    }

    /** Keys that were withdrawn, in order. */
    public List<Fingerprint> withdrawn() {
        return new ArrayList<>(content.withdrawn);
    }

    /** The peer with that key; empty for an unknown or withdrawn one. */
    public Optional<Peer> find(Fingerprint fingerprint) {
        return Optional.ofNullable(content.peers.get(fingerprint));
    }

    /** Whether a key was withdrawn and not paired again since. */
    public boolean isWithdrawn(Fingerprint fingerprint) {
        return content.withdrawn.contains(fingerprint);
    }

    /** Adds a peer, or changes its name and role. */
    public synchronized void add(Peer peer) throws IOException {
        Content next = content.copy();
        next.withdrawn.remove(peer.fingerprint());
        next.peers.put(peer.fingerprint(), peer);
        if (next.peers.size() > MOST_PEERS) {
            throw new IOException("no more than " + MOST_PEERS + " keys are kept");
        }
        keep(next);
    }

    /**
     * Withdraws keys, known or not. A peer's key is withdrawn even where no more withdrawn keys are remembered; it is then a key that nobody knows.
     *
     * @return those that were not withdrawn before
     */
    public synchronized List<Fingerprint> withdraw(List<Fingerprint> keys) throws IOException {
        Content next = content.copy();
        List<Fingerprint> news = new ArrayList<>();
        for (Fingerprint key : keys) {
            boolean known = next.peers.remove(key) != null;
            boolean remembered = next.withdrawn.size() < MOST_PEERS && next.withdrawn.add(key);
            if (known || remembered) {
                news.add(key);
            }
        }
        if (!news.isEmpty()) {
            keep(next);
        }
        return news;
    }

    private void keep(Content next) throws IOException {
        keeper.keep(next);
        content = next;
    }

    Content content() {
        return content;
    }

    /** Peers and withdrawn keys. */
    public static final class Content {
        static final Content EMPTY = new Content();

        private final Map<Fingerprint, Peer> peers = new LinkedHashMap<>();
        private final Set<Fingerprint> withdrawn = new LinkedHashSet<>();

        private Content() {}

        private Content copy() {
            Content copy = new Content();
            copy.peers.putAll(peers);
            copy.withdrawn.addAll(withdrawn);
            return copy;
        }

        /** A line for each key: its role or {@code WITHDRAWN}, the fingerprint, and a peer's name. */
        String text() {
            StringBuilder text = new StringBuilder();
            for (Peer peer : peers.values()) {
                text.append(peer.role()).append(' ').append(peer.fingerprint()).append(' ');
                text.append(peer.name()).append('\n');
            }
            for (Fingerprint key : withdrawn) {
                text.append("WITHDRAWN ").append(key).append('\n');
            }
            return text.toString();
        }

        static Content parse(String where, String text) throws IOException {
            Content content = new Content();
            int number = 0;
            for (String line : text.split("\n")) {
                number++;
                try {
                    content.take(line);
                } catch (IllegalArgumentException | ArrayIndexOutOfBoundsException e) {
                    throw new IOException(where + ", line " + number + " is damaged: " + e.getMessage(), e);
                }
            }
            return content;
        }

        private void take(String line) {
            String[] words = line.split(" ", 3);
            if (words[0].equals("WITHDRAWN")) {
                withdrawn.add(Fingerprint.parse(words[1]));
            } else if (!line.isEmpty()) {
                Peer peer = new Peer(Fingerprint.parse(words[1]), words[2], Role.valueOf(words[0]));
                peers.put(peer.fingerprint(), peer);
            }
        }
    }
}
