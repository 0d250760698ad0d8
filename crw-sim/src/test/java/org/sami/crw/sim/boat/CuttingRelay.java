package org.sami.crw.sim.boat;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntUnaryOperator;

/** A router between a base and a boat that cuts each connection after so many bytes of the boat. */
final class CuttingRelay implements Closeable {
    private final ServerSocket server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    private final InetSocketAddress boat;
    private final IntUnaryOperator bytesOfConnection;
    private final AtomicInteger connections = new AtomicInteger();

    /** A relay; the number of the connection, from 0, gives how many bytes pass. */
    CuttingRelay(InetSocketAddress boat, IntUnaryOperator bytesOfConnection) throws IOException {
        this.boat = boat;
        this.bytesOfConnection = bytesOfConnection;
        daemon(this::accept);
    }

    InetSocketAddress address() {
        return (InetSocketAddress) server.getLocalSocketAddress();
    }

    int connections() {
        return connections.get();
    }

    private void accept() {
        try {
            while (true) {
                Socket client = server.accept();
                Socket behind = new Socket();
                behind.connect(boat);
                int most = bytesOfConnection.applyAsInt(connections.getAndIncrement());
                daemon(() -> pass(client, behind, Integer.MAX_VALUE));
                daemon(() -> pass(behind, client, most));
            }
        } catch (IOException e) {
            // closed
        }
    }

    private static void pass(Socket from, Socket to, int most) {
        try (from;
                to) {
            InputStream in = from.getInputStream();
            OutputStream out = to.getOutputStream();
            byte[] buffer = new byte[4096];
            int left = most;
            while (left > 0) {
                int read = in.read(buffer, 0, Math.min(buffer.length, left));
                if (read < 0) {
                    return;
                }
                out.write(buffer, 0, read);
                left -= read;
            }
        } catch (IOException e) {
            // the other side has gone
        }
    }

    private static void daemon(Runnable work) {
        Thread thread = new Thread(work, "relay");
        thread.setDaemon(true);
        thread.start();
    }

    @Override
    public void close() throws IOException {
        server.close();
    }
}
