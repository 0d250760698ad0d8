package org.sami.boat.server.tcp;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.LinkSecurity;
import org.sami.boat.link.security.OpenLinks;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.TlsLinks;
import org.sami.boat.server.BoatKeys;
import org.sami.boat.server.file.BoatFiles;

/** What is set for a boat's TCP side before it starts. Immutable; a value that makes no sense is refused. */
public final class TcpServerConfig {
    private final InetSocketAddress address;
    private final long tickMs;
    private final int maxClients;
    private final int helloWithinMs;
    private final int silentAfterMs;
    private final int maxQueuedFrames;
    private final int maxQueuedBytes;
    private final LinkSecurity security;
    private final Optional<BoatKeys> keys;
    private final BoatFiles files;

    private TcpServerConfig(
            InetSocketAddress address,
            long tickMs,
            int maxClients,
            int helloWithinMs,
            int silentAfterMs,
            int maxQueuedFrames,
            int maxQueuedBytes,
            LinkSecurity security,
            Optional<BoatKeys> keys,
            BoatFiles files) {
        this.address = Objects.requireNonNull(address, "address");
        this.tickMs = positive("time between ticks", tickMs);
        this.maxClients = (int) positive("number of clients", maxClients);
        this.helloWithinMs = (int) positive("time for the hello", helloWithinMs);
        this.silentAfterMs = (int) positive("time of silence", silentAfterMs);
        this.maxQueuedFrames = (int) positive("number of frames in a queue", maxQueuedFrames);
        this.security = Objects.requireNonNull(security, "security");
        this.keys = Objects.requireNonNull(keys, "keys");
        this.files = Objects.requireNonNull(files, "files");
        this.maxQueuedBytes = (int) positive("number of bytes in a queue", maxQueuedBytes);
    }

    /** The defaults on a port of the loopback address; port 0 takes a free one. */
    public static TcpServerConfig onLoopback(int port) {
        return on(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    }

    /**
     * The defaults on an address: ticks every 100 ms, 16 clients, hello within 10 s, dropped after 10 s without a byte, 512 frames
     * or 8 MiB that a client does not take.
     */
    public static TcpServerConfig on(InetSocketAddress address) {
        return new TcpServerConfig(
                address, 100, 16, 10_000, 10_000, 512, 8 << 20, new OpenLinks(), Optional.empty(), BoatFiles.none());
    }

    /** The same with other bounds on the messages waiting for a slow client. */
    public TcpServerConfig withQueue(int frames, int bytes) {
        return new TcpServerConfig(
                address, tickMs, maxClients, helloWithinMs, silentAfterMs, frames, bytes, security, keys, files);
    }

    /** The same with other limits on clients that say nothing: for the hello, and between two bytes. */
    public TcpServerConfig withPatience(int newHelloWithinMs, int newSilentAfterMs) {
        return new TcpServerConfig(
                address,
                tickMs,
                maxClients,
                newHelloWithinMs,
                newSilentAfterMs,
                maxQueuedFrames,
                maxQueuedBytes,
                security,
                keys,
                files);
    }

    /** The same with another bound on clients at a time. */
    public TcpServerConfig withMaxClients(int clients) {
        return new TcpServerConfig(
                address,
                tickMs,
                clients,
                helloWithinMs,
                silentAfterMs,
                maxQueuedFrames,
                maxQueuedBytes,
                security,
                keys,
                files);
    }

    /** The same with protected links: only clients with known keys command. */
    public TcpServerConfig withKeys(KeyRing ring, PairingResponder responder) {
        return new TcpServerConfig(
                address,
                tickMs,
                maxClients,
                helloWithinMs,
                silentAfterMs,
                maxQueuedFrames,
                maxQueuedBytes,
                TlsLinks.of(ring),
                Optional.of(new BoatKeys(ring, responder)),
                files);
    }

    /** The same with files that every client may fetch which is allowed to observe. */
    public TcpServerConfig withFiles(BoatFiles given) {
        return new TcpServerConfig(
                address,
                tickMs,
                maxClients,
                helloWithinMs,
                silentAfterMs,
                maxQueuedFrames,
                maxQueuedBytes,
                security,
                keys,
                given);
    }

    /** The files that clients may fetch. */
    public BoatFiles files() {
        return files;
    }

    /** How connections are protected. */
    LinkSecurity security() {
        return security;
    }

    /** What keys may do; empty where links are not protected. */
    Optional<BoatKeys> keys() {
        return keys;
    }

    /** Where it listens. */
    public InetSocketAddress address() {
        return address;
    }

    /** Time in ms between two ticks of the boat. */
    public long tickMs() {
        return tickMs;
    }

    /** Most clients at a time; {@link ConnectionSlots} decides which to drop beyond it. */
    public int maxClients() {
        return maxClients;
    }

    /** A client that has not said a hello after this time in ms is dropped. */
    public int helloWithinMs() {
        return helloWithinMs;
    }

    /** A client from which no byte, or no readable frame, has come for this time in ms is dropped, long after its link has counted as lost. */
    public int silentAfterMs() {
        return silentAfterMs;
    }

    /** A client that lets more frames wait is dropped. */
    public int maxQueuedFrames() {
        return maxQueuedFrames;
    }

    /** A client that lets more bytes wait is dropped. */
    public int maxQueuedBytes() {
        return maxQueuedBytes;
    }

    private static long positive(String name, long value) {
        if (value <= 0) {
            throw new IllegalArgumentException("the " + name + " is positive, not " + value);
        }
        return value;
    }
}
