package org.sami.crw.session.key;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.sami.boat.link.security.KeyRing;
import org.sami.crw.proxy.key.BaseKeys;

/**
 * The keys of this base as a window shows them, and what a person does with them: each operation reads and writes the disk on a thread of its own, one after
 * another, and says what came of it. To be used on the thread of its front, on which its listeners are called.
 */
public final class KeyWork {
    private final BaseKeys keys;
    private final Executor front;
    private final Taking withdrawn;
    private final Runnable changed;
    private final Object oneAtATime = new Object();
    private Optional<BaseKeys.Listing> listing = Optional.empty();
    private String said = "";
    private boolean bad;
    private boolean busy;

    /** Has links take keys that have changed. */
    @FunctionalInterface
    public interface Taking {
        /** Takes them. */
        void run() throws IOException;
    }

    /**
     * What can be done with keys.
     *
     * @param front runs what this tells
     * @param withdrawn is run off it after keys have changed, so that links take them
     * @param changed is called on the front after each change
     */
    public KeyWork(BaseKeys keys, Executor front, Taking withdrawn, Runnable changed) {
        this.keys = keys;
        this.front = front;
        this.withdrawn = withdrawn;
        this.changed = changed;
    }

    private interface Work {
        /** Does it, and says what came of it. */
        String run() throws IOException;
    }

    private void work(String begins, Work work) {
        said = begins;
        bad = false;
        busy = true;
        changed.run();
        Thread thread = new Thread(
                () -> {
                    synchronized (oneAtATime) {
                        try {
                            String done = work.run();
                            BaseKeys.Listing now = keys.list();
                            front.execute(() -> ended(done, false, Optional.of(now)));
                        } catch (IOException | IllegalArgumentException fault) {
                            front.execute(() -> ended(String.valueOf(fault.getMessage()), true, Optional.empty()));
                        }
                    }
                },
                "keys of this base");
        thread.setDaemon(true);
        thread.start();
    }

    private void ended(String what, boolean wrong, Optional<BaseKeys.Listing> now) {
        said = what;
        bad = wrong;
        busy = false;
        listing = now.or(() -> listing);
        changed.run();
    }

    /** Reads the keys; an own one is made where there is none yet. */
    public void read() {
        work("", () -> "");
    }

    /** Withdraws a key: a boat's name, or a fingerprint of a laptop that was lost. */
    public void withdraw(String key) {
        work("Withdrawing", () -> {
            String named = keys.withdraw(List.of(key)).get(0).shortText();
            withdrawn.run();
            return "The key " + named + " is withdrawn here; boats learn it as soon as this base commands them";
        });
    }

    /** Writes all keys to a file under a password, which is wiped. */
    public void exportTo(Path file, char[] password, char[] repeated) {
        boolean equal = Arrays.equals(password, repeated);
        Arrays.fill(repeated, ' ');
        work("Encrypting", () -> {
            if (!equal) {
                Arrays.fill(password, ' ');
                throw new IllegalArgumentException("the two passwords differ");
            }
            KeyRing ring = keys.exportTo(file, password);
            return file + " has this base's key and " + boats(ring) + fleet();
        });
    }

    /** Takes the keys of such a file in place of those that are here; the password is wiped. */
    public void importFrom(Path file, char[] password) {
        work("Decrypting", () -> {
            KeyRing ring = keys.importFrom(file, password, true);
            withdrawn.run();
            return "This base has the key " + ring.identity().fingerprint().shortText() + " and " + boats(ring)
                    + " now; links are made with it from now on" + fleet();
        });
    }

    /** Makes the key with which vehicles of other makers sign; one that there is already stays. */
    public void makeFleetKey() {
        work("Making a key", () -> {
            boolean present = keys.fleetKey().isPresent();
            keys.makeFleetKey();
            return present
                    ? "The fleet has a key already" + fleet()
                    : "The key is made; no vehicle signs with it before it is given to it";
        });
    }

    /** Makes another such key in place of the present one. */
    public void renewFleetKey() {
        work("Making a key", () -> {
            keys.renewFleetKey();
            return "The key is replaced. Vehicles obey the one before it until each is given the new one over its cable;"
                    + " a session that runs goes on with those that it has heard until then";
        });
    }

    /** That the fleet's key is among the keys, where there is one. */
    private String fleet() throws IOException {
        return keys.shownFleetKey()
                .map(key -> "; vehicles sign with the key " + key.fingerprint())
                .orElse("");
    }

    private static String boats(KeyRing ring) {
        int boats = ring.peers().size();
        return boats == 1 ? "1 boat" : boats + " boats";
    }

    /** The folder of the keys. */
    public Path folder() {
        return keys.folder();
    }

    /** What is kept, as it was read last; empty before the first time. */
    public Optional<BaseKeys.Listing> listing() {
        return listing;
    }

    /** What came of the last operation, in words. */
    public String said() {
        return said;
    }

    /** Whether the last operation failed. */
    public boolean isBad() {
        return bad;
    }

    /** Whether one is under way. */
    public boolean isBusy() {
        return busy;
    }
}
