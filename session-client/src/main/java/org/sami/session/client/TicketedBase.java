package org.sami.session.client;

import java.net.URLEncoder;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.nio.charset.StandardCharsets;
import java.time.Duration;

/**
 * The base that holds the session, as it gives pictures and logs over HTTP for as long as a connection to it lasts. Immutable.
 *
 * @param client trusts its certificate only
 * @param ticket what that connection shows
 */
record TicketedBase(SessionAddress address, HttpClient client, String ticket) {
    private static final Duration LIMIT = Duration.ofMinutes(2); // of one request

    /** The base at an address. */
    static TicketedBase of(SessionAddress address, ServerTrust trust, String ticket) {
        HttpClient.Builder builder = HttpClient.newBuilder();
        return new TicketedBase(
                address,
                address.secure() ? builder.sslContext(trust.context(address)).build() : builder.build(),
                ticket);
    }

    /** The same base after another login, at a client that is open already. */
    TicketedBase with(String another) {
        return new TicketedBase(address, client, another);
    }

    /** A request for a path with its query. */
    HttpRequest request(String path) {
        return HttpRequest.newBuilder(address.page(path))
                .header("Authorization", "Bearer " + ticket)
                .timeout(LIMIT)
                .build();
    }

    /** A text as a query has it. */
    static String encoded(String text) {
        return URLEncoder.encode(text, StandardCharsets.UTF_8);
    }
}
