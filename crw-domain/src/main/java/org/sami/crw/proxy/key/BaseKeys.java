package org.sami.crw.proxy.key;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyBundle;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.Peer;

/**
 * The keys of this base in a folder: what {@code crw keys} and the window do with them. Each operation reads and writes the disk, so it is for no event thread.
 */
public final class BaseKeys {
    /** The fewest characters of a password. */
    public static final int SHORTEST_PASSWORD = 8;

    private static final int FLEET_KEY_BYTES = 32; // as MAVLink 2 signs

    private final Path folder;

    /**
     * What is kept.
     *
     * @param own the key of this base
     * @param boats that are paired with it, in the order in which they were
     * @param withdrawn keys that were withdrawn, in order
     * @param fleet with which vehicles of other makers sign; empty where none was made
     */
    public record Listing(Fingerprint own, List<Known> boats, List<Fingerprint> withdrawn, Optional<FleetKey> fleet) {
        public Listing {
            boats = List.copyOf(boats);
            withdrawn = List.copyOf(withdrawn);
        }
    }

    /**
     * A boat that is paired with this base.
     *
     * @param boat its key and name, and what it grants this base
     * @param seenMillis when this base was linked to it last, in ms since 1970
     */
    public record Known(Peer boat, Optional<Long> seenMillis) {}

    /** The keys in a folder, which need not exist yet. */
    public BaseKeys(Path folder) {
        this.folder = folder;
    }

    /** The folder. */
    public Path folder() {
        return folder;
    }

    /** Whether there are keys yet. */
    public boolean exist() {
        return new KeyStoreFolder(folder).exists();
    }

    /**
     * The keys; an own one is made where there is none.
     *
     * @throws IOException if they cannot be read, or the first cannot be written
     */
    public KeyRing open() throws IOException {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new IOException(folder + " is a file: the keys of a base are a folder");
        }
        return new KeyStoreFolder(folder).open();
    }

    /**
     * The secret with which the vehicles of other makers in this base's fleet sign; empty where none was made.
     *
     * @throws IOException if it cannot be read
     */
    public Optional<byte[]> fleetKey() throws IOException {
        return new KeyStoreFolder(folder).fleetKey();
    }

    /**
     * The same as people see it.
     *
     * @throws IOException as {@link #fleetKey}
     */
    public Optional<FleetKey> shownFleetKey() throws IOException {
        Optional<Instant> since = new KeyStoreFolder(folder).fleetKeySince();
        return fleetKey().map(secret -> FleetKey.of(secret, since.orElse(Instant.EPOCH)));
    }

    /**
     * The secret with which the fleet signs; one is made where there is none.
     *
     * @throws IOException if it cannot be read or written
     */
    public byte[] makeFleetKey() throws IOException {
        open(); // the folder, with the key of this base
        Optional<byte[]> present = fleetKey();
        return present.isPresent() ? present.get() : renewFleetKey();
    }

    /**
     * Makes another secret for the fleet in place of the present one, as where a laptop that has it was lost. Vehicles that have the present one obey it until they
     * are given the new one.
     *
     * @throws IOException if it cannot be written
     */
    public byte[] renewFleetKey() throws IOException {
        open(); // the folder, with the key of this base
        byte[] made = new byte[FLEET_KEY_BYTES];
        new SecureRandom().nextBytes(made);
        new KeyStoreFolder(folder).writeFleetKey(made);
        return made;
    }

    /**
     * What is kept.
     *
     * @throws IOException as {@link #open}
     */
    public Listing list() throws IOException {
        KeyRing ring = open();
        Map<Fingerprint, Long> seen = new LastSeen(folder).all();
        List<Known> boats = ring.peers().stream()
                .map(peer -> new Known(peer, Optional.ofNullable(seen.get(peer.fingerprint()))))
                .toList();
        return new Listing(ring.identity().fingerprint(), boats, ring.withdrawn(), shownFleetKey());
    }

    /**
     * Withdraws keys; boats learn it when this base commands them next.
     *
     * @param texts a boat's name, the beginning of its fingerprint, or a fingerprint in full: of a laptop that was lost
     * @return those that are withdrawn
     * @throws IllegalArgumentException in words, if a text names no key or this base's own; none is withdrawn then
     * @throws IOException if the keys cannot be read or written
     */
    public List<Fingerprint> withdraw(List<String> texts) throws IOException {
        KeyRing ring = open();
        List<Fingerprint> chosen = new ArrayList<>();
        for (String text : texts) {
            chosen.add(find(ring, text.strip()));
        }
        if (chosen.contains(ring.identity().fingerprint())) {
            throw new IllegalArgumentException("a base does not withdraw its own key: do it at another base");
        }
        ring.withdraw(chosen);
        return chosen;
    }

    private static Fingerprint find(KeyRing ring, String text) {
        if (text.length() == Fingerprint.DIGITS) {
            return Fingerprint.parse(text);
        }
        return ring.peers().stream()
                .filter(peer -> peer.name().equals(text)
                        || (!text.isEmpty() && peer.fingerprint().toString().startsWith(text)))
                .findFirst()
                .map(Peer::fingerprint)
                .orElseThrow(() -> new IllegalArgumentException("no key here is named '" + text
                        + "'; the key of a lost laptop is written in full, as it was shown there (crw keys list)"));
    }

    /**
     * Writes all keys to one encrypted file; an existing one is replaced.
     *
     * @param password is wiped
     * @return what was written
     * @throws IllegalArgumentException in words, if the password is too short
     * @throws IOException if the keys cannot be read or the file cannot be written
     */
    public KeyRing exportTo(Path file, char[] password) throws IOException {
        try {
            checkPassword(password);
            KeyRing ring = open();
            KeyBundle.write(file, ring, new KeyStoreFolder(folder).fleetKey(), password);
            return ring;
        } finally {
            Arrays.fill(password, ' ');
        }
    }

    /**
     * Takes the keys of such a file, in place of those of this base.
     *
     * @param password is wiped
     * @param replace whether keys that this base has are given up
     * @throws IllegalArgumentException in words, if the password is too short, or there are keys that are not to be given up
     * @throws IOException if the file is none or damaged, or the password is another one; the keys of this base are as before then
     */
    public KeyRing importFrom(Path file, char[] password, boolean replace) throws IOException {
        try {
            if (exist() && !replace) {
                throw new IllegalArgumentException("this base has keys already, which would be given up");
            }
            checkPassword(password);
            return KeyBundle.read(file, password, new KeyStoreFolder(folder));
        } finally {
            Arrays.fill(password, ' ');
        }
    }

    private static void checkPassword(char[] password) {
        if (password.length < SHORTEST_PASSWORD) {
            throw new IllegalArgumentException("a password has " + SHORTEST_PASSWORD + " characters at least");
        }
    }

    /** The name under which boats keep the key of this base. */
    public static String nameOfThisBase() {
        try {
            return System.getProperty("user.name") + " at "
                    + InetAddress.getLocalHost().getHostName();
        } catch (IOException noName) {
            return System.getProperty("user.name") + "'s base";
        }
    }
}
