package org.sami.boat.server.testing;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.UnaryOperator;

/** A wire to a boat with somebody in between who records what both sides say, and may change what a client says. */
public final class TappedWire implements AutoCloseable {
    public static final UnaryOperator<byte[]> UNCHANGED = sent -> sent;

    /** Makes a client's first message one of TLS 1.2: the extension that lists newer versions gets a number that nobody knows. */
    public static final UnaryOperator<byte[]> WITHOUT_VERSIONS = TappedWire::withoutVersions;

    private static final int RECORD_AND_MESSAGE_HEADER = 9;
    private static final int VERSION_AND_RANDOM = 34;
    private static final short SUPPORTED_VERSIONS = 43;
    private static final short UNKNOWN = 0x5a5a;

    private final ServerSocket socket = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final InetSocketAddress boat;
    private final UnaryOperator<byte[]> first;
    private final ByteArrayOutputStream recorded = new ByteArrayOutputStream(); // what clients have said
    private final ByteArrayOutputStream answered = new ByteArrayOutputStream(); // what the boat has said
    private final Set<Socket> open = ConcurrentHashMap.newKeySet();
    private volatile boolean changed;
    private volatile boolean flips;

    /** The first bytes of each client go through {@code first}. */
    public TappedWire(InetSocketAddress boat, UnaryOperator<byte[]> first) throws IOException {
        this.boat = boat;
        this.first = first;
        start(this::accept);
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "tapped-wire");
        thread.setDaemon(true);
        thread.start();
    }

    public int port() {
        return socket.getLocalPort();
    }

    /** Where clients find the boat. */
    public InetSocketAddress address() {
        return (InetSocketAddress) socket.getLocalSocketAddress();
    }

    /** All that clients have sent so far. */
    public byte[] recorded() {
        synchronized (recorded) {
            return recorded.toByteArray();
        }
    }

    /** All that the boat has sent so far. */
    public byte[] answered() {
        synchronized (answered) {
            return answered.toByteArray();
        }
    }

    /** Whether the first bytes of a client were changed. */
    public boolean changed() {
        return changed;
    }

    /** Flips one bit of what the client sends next. */
    public void flipOneBit() {
        flips = true;
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                Socket client = socket.accept();
                Socket server = new Socket(boat.getAddress(), boat.getPort());
                open.add(client);
                open.add(server);
                start(() -> copy(server, client, bytes -> keep(answered, bytes)));
                start(() -> copy(client, server, tap()));
            } catch (IOException e) {
                return; // closed
            }
        }
    }

    private static byte[] keep(ByteArrayOutputStream record, byte[] bytes) {
        synchronized (record) {
            record.writeBytes(bytes);
        }
        return bytes;
    }

    private void copy(Socket from, Socket to, UnaryOperator<byte[]> through) {
        byte[] buffer = new byte[16_384];
        try (from;
                to) {
            InputStream in = from.getInputStream();
            OutputStream out = to.getOutputStream();
            for (int read = in.read(buffer); read > 0; read = in.read(buffer)) {
                out.write(through.apply(Arrays.copyOf(buffer, read)));
            }
        } catch (IOException e) {
            // one side is gone: so does the other
        } finally {
            open.remove(from);
            open.remove(to);
        }
    }

    /** What is done to the bytes of one client, in order. */
    private UnaryOperator<byte[]> tap() {
        AtomicBoolean begun = new AtomicBoolean();
        return bytes -> {
            byte[] sent = begun.getAndSet(true) ? bytes : first.apply(bytes.clone());
            if (!Arrays.equals(sent, bytes)) {
                changed = true;
            }
            keep(recorded, sent);
            if (flips) {
                flips = false;
                sent[sent.length / 2] ^= 1;
            }
            return sent;
        };
    }

    private static byte[] withoutVersions(byte[] hello) {
        ByteBuffer buffer = ByteBuffer.wrap(hello);
        buffer.position(RECORD_AND_MESSAGE_HEADER + VERSION_AND_RANDOM);
        skip(buffer, buffer.get() & 0xff); // the session's id
        skip(buffer, buffer.getShort() & 0xffff); // the ciphers
        skip(buffer, buffer.get() & 0xff); // the kinds of compression
        buffer.getShort(); // the length of all extensions
        while (buffer.hasRemaining()) {
            int at = buffer.position();
            if (buffer.getShort() == SUPPORTED_VERSIONS) {
                buffer.putShort(at, UNKNOWN);
            }
            skip(buffer, buffer.getShort() & 0xffff);
        }
        return hello;
    }

    private static void skip(ByteBuffer buffer, int bytes) {
        buffer.position(buffer.position() + bytes);
    }

    @Override
    public void close() throws IOException {
        socket.close();
        for (Socket each : open) {
            each.close();
        }
    }
}
