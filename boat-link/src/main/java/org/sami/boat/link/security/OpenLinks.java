package org.sami.boat.link.security;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.util.Optional;

/** No protection: whoever reaches the port commands the boat. For simulated boats on loopback. */
public final class OpenLinks implements LinkSecurity {
    @Override
    public SecureLink accept(Socket socket) {
        return of(socket);
    }

    @Override
    public SecureLink connect(Socket socket) {
        return of(socket);
    }

    private static SecureLink of(Socket socket) {
        return new SecureLink() {
            @Override
            public InputStream in() throws IOException {
                return socket.getInputStream();
            }

            @Override
            public OutputStream out() throws IOException {
                return socket.getOutputStream();
            }

            @Override
            public Optional<Fingerprint> peer() {
                return Optional.empty();
            }
        };
    }
}
