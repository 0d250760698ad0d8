package org.sami.boat.app.boat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.Role;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.PairingCode;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.link.security.Peer;

/**
 * The key of the boat on a phone, made at the first start, the bases that are paired with it, and the pairing of another one. All is in the app's private
 * storage. Safe for use by several threads.
 */
public final class PhoneKeys {
    private final AppFiles files;
    private final String boatName;
    private final KeyRing ring;
    private final PairingResponder responder;
    private volatile boolean open;
    private volatile Optional<PairingSecret> words = Optional.empty();
    private volatile long untilMs;
    private volatile Optional<NewBase> newBase = Optional.empty();

    /** A base that has just proved itself. Immutable. */
    public static final class NewBase {
        private final Peer base;
        private final String checkCode;
        private final boolean kept;

        NewBase(Peer base, String checkCode, boolean kept) {
            this.base = base;
            this.checkCode = checkCode;
            this.kept = kept;
        }

        /** The base. */
        public Peer base() {
            return base;
        }

        /** Six digits that the base shows too, unless somebody is in between. */
        public String checkCode() {
            return checkCode;
        }
    }

    /**
     * The keys in the app's files; an own key is made if there is none yet.
     *
     * @throws IOException if a file is damaged, cannot be read or written, or may be read by others
     */
    PhoneKeys(AppFiles files, String boatName) throws IOException {
        this.files = files;
        this.boatName = boatName;
        ring = new KeyStoreFolder(files.keys()).open();
        responder = new PairingResponder(ring, this::paired);
        open = Files.exists(files.openLinks());
    }

    KeyRing ring() {
        return ring;
    }

    PairingResponder responder() {
        return responder;
    }

    /** Names the own key. */
    public Fingerprint own() {
        return ring.identity().fingerprint();
    }

    /** The paired bases, in the order in which they were paired. */
    public List<Peer> bases() {
        return ring.peers();
    }

    /** Who may command the boat, as it is announced. */
    BoatAnnouncement.Access access(long nowMs) {
        if (open) {
            return BoatAnnouncement.Access.OPEN;
        }
        return words(nowMs).isPresent() ? BoatAnnouncement.Access.PAIRING : BoatAnnouncement.Access.PAIRED;
    }

    /** Whether links are open: whoever reaches the port commands the boat. */
    public boolean areLinksOpen() {
        return open;
    }

    /**
     * Opens the links to everybody, or protects them; it counts from the next start of the boat on.
     *
     * @throws IOException if it cannot be kept; nothing has changed then
     */
    public void setLinksOpen(boolean toAll) throws IOException {
        if (toAll) {
            AppFiles.write(files.openLinks(), "");
        } else {
            Files.deleteIfExists(files.openLinks());
        }
        open = toAll;
    }

    /**
     * Begins to pair one base: new words count for {@link PairingResponder#OPEN_MS}.
     *
     * @param nowMs on the boat's clock
     */
    public void beginPairing(Role granted, long nowMs) {
        newBase = Optional.empty();
        untilMs = nowMs + PairingResponder.OPEN_MS;
        words = Optional.of(responder.open(granted, nowMs));
    }

    /** Ends a pairing that was begun: its words count no longer. */
    public void endPairing(long nowMs) {
        if (words(nowMs).isPresent()) {
            responder.open(Role.OBSERVER, nowMs - PairingResponder.OPEN_MS); // those that count are over by now
        }
        words = Optional.empty();
    }

    /** The words to be shown; empty where no pairing goes on, as after five wrong tries or when their time is over. */
    public Optional<PairingSecret> words(long nowMs) {
        return responder.isOpen(nowMs) ? words : Optional.empty();
    }

    /** For how long in s the words still count; 0 where there are none. */
    public long secondsLeft(long nowMs) {
        return words(nowMs).isPresent() ? Math.max(0, (untilMs - nowMs + 999) / 1000) : 0;
    }

    /**
     * What the QR code says.
     *
     * @param address {@code HOST:PORT} of the boat's server; empty if the phone is in no network
     */
    public Optional<PairingCode> code(String address, long nowMs) {
        return words(nowMs).map(secret -> new PairingCode(address, boatName, own(), secret));
    }

    private void paired(Peer base, String checkCode) {
        newBase = Optional.of(new NewBase(base, checkCode, true));
        words = Optional.empty();
    }

    /**
     * Calls the base whose code was read ({@link PairingCode}, shown by {@code crw phone}), and has both sides prove that they know its words. Its key is kept once
     * its check code is confirmed. Blocks for some seconds.
     *
     * @param granted the most that the base may do
     * @throws IOException with the reason as one sentence; nothing has changed then
     */
    public void call(PairingCode code, Role granted) throws IOException {
        Peer base = new BaseCall(code, ring.identity(), boatName).prove(granted);
        newBase = Optional.of(new NewBase(base, PairingSecret.checkCode(base.fingerprint(), own()), false));
    }

    /** The base that has proved itself last and whose check code nobody has looked at yet. */
    public Optional<NewBase> newBase() {
        return newBase;
    }

    /**
     * The base shows the same check code: it is the one.
     *
     * @throws IOException if its key cannot be kept; it waits on then
     */
    public void confirm() throws IOException {
        Optional<NewBase> right = newBase;
        if (right.isPresent() && !right.get().kept) {
            ring.add(right.get().base());
        }
        newBase = Optional.empty();
    }

    /**
     * The base shows another check code: somebody was in between, and the new key is withdrawn.
     *
     * @throws IOException if it cannot be withdrawn
     */
    public void refuse() throws IOException {
        Optional<NewBase> wrong = newBase;
        if (wrong.isPresent() && wrong.get().kept) {
            withdraw(wrong.get().base());
        }
        newBase = Optional.empty();
    }

    /**
     * From now on a base is a stranger, on a link that stands too.
     *
     * @throws IOException if it cannot be kept; nothing has changed then
     */
    public void withdraw(Peer base) throws IOException {
        ring.withdraw(Collections.singletonList(base.fingerprint()));
        newBase = newBase.filter(one -> !one.base().fingerprint().equals(base.fingerprint()));
    }
}
