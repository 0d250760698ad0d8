package org.sami.mavlink.link;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.BindException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetSocketAddress;
import java.net.PortUnreachableException;
import java.net.SocketAddress;
import java.net.UnknownHostException;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;

/**
 * A UDP port as streams: datagrams are read one after the other, and each packet that is written is one datagram. A port that listens sends to all from whom it
 * has heard lately, as several vehicles may share it: to the last 64.
 */
final class UdpStreams implements LinkStreams {
    private static final int MAX_DATAGRAM = 65_535;
    private static final int MAX_PEERS = 64; // more senders than that are no fleet

    private final DatagramSocket socket;
    private final Optional<InetSocketAddress> other;
    private final Set<SocketAddress> heard = new LinkedHashSet<>(); // the one that is silent for longest first
    private final InputStream in = new Datagrams();
    private final OutputStream out = new Packets();

    private UdpStreams(DatagramSocket socket, Optional<InetSocketAddress> other) {
        this.socket = socket;
        this.other = other;
    }

    static UdpStreams listen(int port) throws IOException {
        try {
            return new UdpStreams(new DatagramSocket(port), Optional.empty());
        } catch (BindException e) {
            throw new IOException("another program listens on UDP port " + port, e);
        }
    }

    static UdpStreams to(String host, int port) throws IOException {
        InetSocketAddress address = new InetSocketAddress(host, port);
        if (address.isUnresolved()) {
            throw new UnknownHostException("there is no host " + host);
        }
        return new UdpStreams(new DatagramSocket(), Optional.of(address));
    }

    @Override
    public InputStream in() {
        return in;
    }

    @Override
    public OutputStream out() {
        return out;
    }

    @Override
    public void close() {
        socket.close();
    }

    private synchronized void hear(SocketAddress from) {
        heard.remove(from);
        heard.add(from);
        if (heard.size() > MAX_PEERS) {
            heard.remove(heard.iterator().next());
        }
    }

    private synchronized Set<SocketAddress> receivers() {
        return other.<Set<SocketAddress>>map(Set::of).orElseGet(() -> Set.copyOf(heard));
    }

    /** What comes, datagram after datagram. Read by one thread. */
    private final class Datagrams extends InputStream {
        private final byte[] buffer = new byte[MAX_DATAGRAM];
        private int next;
        private int end;

        @Override
        public int read() throws IOException {
            byte[] one = new byte[1];
            return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
        }

        @Override
        public int read(byte[] to, int from, int length) throws IOException {
            if (length == 0) {
                return 0;
            }
            while (next == end) {
                receive();
            }
            int part = Math.min(length, end - next);
            System.arraycopy(buffer, next, to, from, part);
            next += part;
            return part;
        }

        private void receive() throws IOException {
            DatagramPacket packet = new DatagramPacket(buffer, buffer.length);
            try {
                socket.receive(packet);
            } catch (PortUnreachableException e) {
                return; // nobody listens there yet; who sends again finds out
            }
            hear(packet.getSocketAddress());
            next = 0;
            end = packet.getLength();
        }
    }

    /** What is sent, a datagram for each packet. Written by one thread. */
    private final class Packets extends OutputStream {
        @Override
        public void write(int one) throws IOException {
            write(new byte[] {(byte) one}, 0, 1);
        }

        @Override
        public void write(byte[] packet, int from, int length) throws IOException {
            for (SocketAddress receiver : receivers()) {
                socket.send(new DatagramPacket(packet, from, length, receiver));
            }
        }
    }
}
