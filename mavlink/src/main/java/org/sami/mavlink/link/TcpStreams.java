package org.sami.mavlink.link;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.time.Duration;

/** A TCP connection. */
record TcpStreams(Socket socket, InputStream in, OutputStream out) implements LinkStreams {
    private static final int CONNECT_MS = 3_000;

    static TcpStreams connect(String host, int port) throws IOException {
        InetSocketAddress address = new InetSocketAddress(host, port);
        if (address.isUnresolved()) {
            throw new UnknownHostException("there is no host " + host);
        }
        Socket socket = new Socket();
        try {
            socket.setTcpNoDelay(true);
            socket.setKeepAlive(true);
            socket.connect(address, CONNECT_MS);
            return new TcpStreams(socket, socket.getInputStream(), socket.getOutputStream());
        } catch (ConnectException e) {
            socket.close();
            throw new IOException("nobody listens there: is the vehicle on, and are host and port right?", e);
        } catch (SocketTimeoutException e) {
            socket.close();
            throw new IOException(
                    "nobody answers within " + CONNECT_MS / 1000 + " s: is this machine in the vehicle's network?", e);
        } catch (IOException e) {
            socket.close();
            throw e;
        }
    }

    @Override
    public void failWhenSilent(Duration time) throws IOException {
        socket.setSoTimeout(Math.toIntExact(time.toMillis()));
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
