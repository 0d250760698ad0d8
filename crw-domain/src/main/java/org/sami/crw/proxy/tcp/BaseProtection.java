package org.sami.crw.proxy.tcp;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.sami.boat.link.security.Fingerprint;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.LinkRefusedException;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.link.security.SecureLink;
import org.sami.boat.link.security.TlsLinks;
import org.sami.crw.proxy.key.LastSeen;

/**
 * How a base protects its links: plain to boats on this machine, with the keys of its user to all others. The keys are read again for each connection, so that
 * what was paired or withdrawn meanwhile counts. Safe for use by several threads.
 */
public final class BaseProtection implements LinkSecurity {
    private static volatile BaseProtection ofThisProcess = new BaseProtection(Optional.empty(), false);

    private final Optional<Path> folder;
    private final boolean open;
    private final Set<InetSocketAddress> simulatedHere = ConcurrentHashMap.newKeySet();
    private volatile Optional<KeyRing> ring = Optional.empty();

    /**
     * Protection of some kind.
     *
     * @param folder of the keys, which then protect links to this machine too; empty for the one of the user
     * @param open whether links to other machines are plain
     */
    public BaseProtection(Optional<Path> folder, boolean open) {
        this.folder = Objects.requireNonNull(folder, "folder");
        this.open = open;
    }

    /** The one that a program of this process uses unless it says otherwise. */
    public static BaseProtection ofThisProcess() {
        return ofThisProcess;
    }

    /** Makes this the one that the process uses; for the start of a program, from its options. */
    public void use() {
        ofThisProcess = this;
    }

    /** Where the keys of this machine's user are. */
    public static Path folderOfThisUser() {
        return Path.of(System.getProperty("user.home"), ".config", "sami", "keys");
    }

    /** The folder of the keys. */
    public Path keysFolder() {
        return folder.orElseGet(BaseProtection::folderOfThisUser);
    }

    /** Links plainly to a boat that this process simulates itself, as long as it does. */
    public void linkPlainly(InetSocketAddress boat, boolean plainly) {
        if (plainly) {
            simulatedHere.add(boat);
        } else {
            simulatedHere.remove(boat);
        }
    }

    /** Whether links to an address are plain. */
    public boolean isPlain(InetSocketAddress address) {
        boolean onThisMachine =
                address.getAddress() != null && address.getAddress().isLoopbackAddress();
        return simulatedHere.contains(address) || (folder.isEmpty() && (open || onThisMachine));
    }

    /**
     * Takes keys that were withdrawn meanwhile, so that links that stand carry them to the boats.
     *
     * @throws IOException if the keys cannot be read
     */
    public void readAgain() throws IOException {
        KeyStoreFolder keys = new KeyStoreFolder(keysFolder());
        if (keys.exists()) {
            ring = Optional.of(keys.open());
        }
    }

    @Override
    public SecureLink accept(Socket socket) throws IOException {
        throw new LinkRefusedException("a base takes no connections");
    }

    @Override
    public SecureLink connect(Socket socket) throws IOException {
        InetSocketAddress address = (InetSocketAddress) socket.getRemoteSocketAddress();
        if (isPlain(address)) {
            return new OpenLinks().connect(socket);
        }
        KeyStoreFolder keys = new KeyStoreFolder(keysFolder());
        if (!keys.exists()) {
            String boat = address.getHostString() + ":" + address.getPort();
            throw new LinkRefusedException(
                    "this base is paired with no boat: Boats > Pair… in the window, crw keys pair " + boat
                            + (folder.isEmpty() ? ", or --open if whoever reaches the boat may command it" : ""));
        }
        KeyRing read = keys.open();
        ring = Optional.of(read);
        SecureLink link = TlsLinks.of(read).connect(socket);
        link.peer().ifPresent(boat -> new LastSeen(keysFolder()).note(boat, System.currentTimeMillis()));
        return link;
    }

    @Override
    public List<Fingerprint> withdrawn() {
        return ring.map(KeyRing::withdrawn).orElse(List.of());
    }
}
