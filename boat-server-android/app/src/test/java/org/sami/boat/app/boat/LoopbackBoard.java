package org.sami.boat.app.boat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.atomic.AtomicLong;
import org.sami.boat.hull.stream.StreamConnection;
import org.sami.boat.hull.stream.StreamPort;
import org.sami.boat.hull.stream.TcpPort;

/** A control board on loopback: it says its battery's voltage for each command that it gets, and keeps the newest command. */
public final class LoopbackBoard implements AutoCloseable {
    private static final byte[] BABBLE = new byte[20_000];

    private final ServerSocket server;
    private volatile String newest = "";
    private volatile boolean babbles;
    private final AtomicLong babbled = new AtomicLong();

    /** A board that waits for its phone. */
    public LoopbackBoard() throws IOException {
        server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
        Thread thread = new Thread(this::serve, "loopback-board");
        thread.setDaemon(true);
        thread.start();
    }

    /** The port of a phone into which no board is plugged. */
    public static final class Absent implements StreamPort {
        @Override
        public String name() {
            return "USB";
        }

        @Override
        public StreamConnection open() throws IOException {
            throw new IOException("no board is plugged in");
        }
    }

    /** Where the phone reaches it. */
    public StreamPort port() {
        return new TcpPort(InetAddress.getLoopbackAddress().getHostAddress(), server.getLocalPort());
    }

    /** The newest line that has come. */
    public String newest() {
        return newest;
    }

    /** From now on it says 20 kB without a line end for each command that it gets, or speaks plainly again. */
    public void babble(boolean on) {
        if (!on) {
            newest = "";
        }
        babbles = on;
    }

    /** How many bytes without a line end it has said. */
    public long babbled() {
        return babbled.get();
    }

    private void serve() {
        while (!server.isClosed()) {
            try (Socket phone = server.accept()) {
                answer(phone);
            } catch (IOException gone) {
                newest = "";
            }
        }
    }

    private void answer(Socket phone) throws IOException {
        BufferedReader lines =
                new BufferedReader(new InputStreamReader(phone.getInputStream(), StandardCharsets.US_ASCII));
        say(phone, "{\"m0\":{\"v\":0,\"c\":0},\"m1\":{\"v\":0,\"c\":0}}");
        String line = lines.readLine();
        while (line != null) {
            newest = line;
            if (babbles) {
                phone.getOutputStream().write(BABBLE);
                babbled.addAndGet(BABBLE.length);
            } else if (babbled.get() > 0) {
                babbled.set(0);
                say(phone, "");
            }
            if (!babbles) {
                say(phone, "{\"s4\":{\"type\":\"battery\",\"data\":\"16.4 0 0\"}}");
            }
            line = lines.readLine();
        }
    }

    private static void say(Socket phone, String line) throws IOException {
        phone.getOutputStream().write((line + "\r\n").getBytes(StandardCharsets.US_ASCII));
    }

    @Override
    public void close() {
        try {
            server.close();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
