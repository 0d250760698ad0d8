package org.sami.session.client;

import java.net.http.HttpClient;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Function;

/** The HTTP client of each base of a session. Each trusts the certificate of its base only. For one thread. */
final class BaseClients implements Function<SessionAddress, HttpClient> {
    private final ServerTrust trust;
    private final Map<SessionAddress, HttpClient> clients = new HashMap<>();

    BaseClients(ServerTrust trust) {
        this.trust = trust;
    }

    @Override
    public HttpClient apply(SessionAddress address) {
        return clients.computeIfAbsent(address, made -> {
            HttpClient.Builder builder = HttpClient.newBuilder();
            return made.secure() ? builder.sslContext(trust.context(made)).build() : builder.build();
        });
    }
}
