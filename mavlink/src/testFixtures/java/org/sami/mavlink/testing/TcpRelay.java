package org.sami.mavlink.testing;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.ArrayList;
import java.util.List;

/** A TCP link to a port of this machine that a test can hold up, as a radio out of range: nothing comes through, and nobody is told. Safe for use by several threads. */
public final class TcpRelay implements AutoCloseable {
    private static final int AT_ONCE = 4096;

    private final ServerSocket server;
    private final int port;
    private final List<Socket> open = new ArrayList<>(); // guarded by this
    private volatile boolean cut;

    /** Listens on a free port for clients of another one. */
    public TcpRelay(int port) throws IOException {
        this.port = port;
        server = new ServerSocket();
        server.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 1);
        begin(this::serve);
    }

    /** Its address for a base. */
    public String address() {
        return "mavlink:tcp:127.0.0.1:" + server.getLocalPort();
    }

    /** What comes in either direction is lost from now on, or passed on again. */
    public void cut(boolean now) {
        cut = now;
    }

    private static void begin(Runnable work) {
        Thread thread = new Thread(work, "tcp relay");
        thread.setDaemon(true);
        thread.start();
    }

    private void serve() {
        while (!server.isClosed()) {
            try {
                Socket client = server.accept();
                Socket there = new Socket(InetAddress.getLoopbackAddress(), port);
                synchronized (this) {
                    open.add(client);
                    open.add(there);
                }
                begin(() -> pass(client, there));
                begin(() -> pass(there, client));
            } catch (IOException e) {
                // nobody listens there yet, or the end: the next client may have more luck
            }
        }
    }

    private void pass(Socket from, Socket to) {
        byte[] bytes = new byte[AT_ONCE];
        try (from;
                to) {
            InputStream in = from.getInputStream();
            OutputStream out = to.getOutputStream();
            for (int read = in.read(bytes); read >= 0; read = in.read(bytes)) {
                if (!cut) {
                    out.write(bytes, 0, read);
                    out.flush();
                }
            }
        } catch (IOException e) {
            // one of the ends is gone, and so is the other
        }
    }

    @Override
    public synchronized void close() throws IOException {
        server.close();
        for (Socket socket : open) {
            socket.close();
        }
    }
}
