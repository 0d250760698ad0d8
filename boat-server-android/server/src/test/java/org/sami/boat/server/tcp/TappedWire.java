package org.sami.boat.server.tcp;

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
import java.util.function.UnaryOperator;

/** A wire to a boat for one client, with somebody in between who records what the client sends, and may change it. */
final class TappedWire implements AutoCloseable {
    static final UnaryOperator<byte[]> UNCHANGED = sent -> sent;

    /** Makes a client's first message one of TLS 1.2: the extension that lists newer versions gets a number that nobody knows. */
    static final UnaryOperator<byte[]> WITHOUT_VERSIONS = TappedWire::withoutVersions;

    private static final int RECORD_AND_MESSAGE_HEADER = 9;
    private static final int VERSION_AND_RANDOM = 34;
    private static final short SUPPORTED_VERSIONS = 43;
    private static final short UNKNOWN = 0x5a5a;

    private final ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
    private final InetSocketAddress boat;
    private final UnaryOperator<byte[]> first;
    private final ByteArrayOutputStream recorded = new ByteArrayOutputStream();
    private volatile Socket client = new Socket();
    private volatile Socket server = new Socket();
    private volatile boolean changed;
    private volatile boolean flips;

    /** The client's first bytes go through {@code first}. */
    TappedWire(InetSocketAddress boat, UnaryOperator<byte[]> first) throws IOException {
        this.boat = boat;
        this.first = first;
        start(this::accept);
    }

    private static void start(Runnable work) {
        Thread thread = new Thread(work, "tapped-wire");
        thread.setDaemon(true);
        thread.start();
    }

    int port() {
        return socket.getLocalPort();
    }

    /** All that the client has sent so far. */
    byte[] recorded() {
        synchronized (recorded) {
            return recorded.toByteArray();
        }
    }

    /** Whether the client's first bytes were changed. */
    boolean changed() {
        return changed;
    }

    /** Flips one bit of what the client sends next. */
    void flipOneBit() {
        flips = true;
    }

    private void accept() {
        try {
            client = socket.accept();
            server = new Socket(boat.getAddress(), boat.getPort());
            start(() -> copy(server, client, false));
            copy(client, server, true);
        } catch (IOException e) {
            // closed
        }
    }

    private void copy(Socket from, Socket to, boolean isOfClient) {
        byte[] buffer = new byte[16_384];
        try (from;
                to) {
            InputStream in = from.getInputStream();
            OutputStream out = to.getOutputStream();
            for (int read = in.read(buffer); read > 0; read = in.read(buffer)) {
                byte[] bytes = Arrays.copyOf(buffer, read);
                out.write(isOfClient ? tap(bytes) : bytes);
            }
        } catch (IOException e) {
            // one side is gone: so does the other
        }
    }

    private byte[] tap(byte[] bytes) {
        byte[] sent = bytes;
        synchronized (recorded) {
            if (recorded.size() == 0) {
                sent = first.apply(bytes.clone());
                changed = !Arrays.equals(sent, bytes);
            }
            recorded.writeBytes(sent);
        }
        if (flips) {
            flips = false;
            sent[sent.length / 2] ^= 1;
        }
        return sent;
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
        client.close();
        server.close();
    }
}
