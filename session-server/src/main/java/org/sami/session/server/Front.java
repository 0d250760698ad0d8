package org.sami.session.server;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.ByteBuffer;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.LongSupplier;
import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.api.StatusCode;
import org.sami.session.person.Person;
import org.sami.session.rows.SentRows;

/**
 * One connection of a front. Its messages arrive one after the other on Jetty's threads, where malformed and excess ones end; all others go to the
 * server's thread. Public as Jetty calls it.
 */
public final class Front implements Session.Listener.AutoDemanding {
    private static final double MESSAGES_PER_SECOND = 50;
    private static final int MESSAGES_AT_ONCE = 200;
    private static final int MOST_MALFORMED = 20;

    private final FrontListener listener;
    private final String address;
    private final LongSupplier nanos;
    private final MessageAllowance allowance;
    private final SentRows rows = new SentRows();
    private final AtomicBoolean ended = new AtomicBoolean();
    private volatile Optional<Person> person = Optional.empty();
    private volatile Optional<Session> socket = Optional.empty();
    private volatile long heardNanos;
    private final Outbox outbox;
    private int malformed; // for the thread of its messages

    /** A connection from an address. */
    Front(FrontListener listener, String address, LongSupplier nanos) {
        this.listener = listener;
        this.address = address;
        this.nanos = nanos;
        allowance = new MessageAllowance(MESSAGES_PER_SECOND, MESSAGES_AT_ONCE, nanos);
        heardNanos = nanos.getAsLong();
        outbox = new Outbox((text, sent) -> socket.ifPresent(one ->
                one.sendText(text, Callback.from(sent, fault -> end(StatusCode.SERVER_ERROR, "")))));
    }

    /** Where it connects from, without its port. */
    String address() {
        return address;
    }

    /** The person's name; empty text before the login. */
    String name() {
        return person.map(Person::name).orElse("");
    }

    Optional<Person> person() {
        return person;
    }

    void login(Person who) {
        person = Optional.of(who);
    }

    SentRows rows() {
        return rows;
    }

    Outbox outbox() {
        return outbox;
    }

    boolean hasEnded() {
        return ended.get();
    }

    /** For how many milliseconds nothing has come from it. */
    long silentMillis() {
        return TimeUnit.NANOSECONDS.toMillis(nanos.getAsLong() - heardNanos);
    }

    void ping() {
        socket.ifPresent(one -> one.sendPing(ByteBuffer.allocate(0), Callback.NOOP));
    }

    /** Sends a message; a front that does not read is closed. */
    void send(String text) {
        if (!ended.get() && !outbox.offer(text)) {
            end(StatusCode.POLICY_VIOLATION, "it does not read");
        }
    }

    void done(long id, CommandReply reply) {
        ObjectNode message = JsonNodeFactory.instance
                .objectNode()
                .put("t", "done")
                .put("id", id)
                .put("text", reply.text());
        message.setAll(reply.more());
        send(message.toString());
    }

    void refuse(long id, String why) {
        send(refusal(id, why).toString());
    }

    private static ObjectNode refusal(long id, String why) {
        return JsonNodeFactory.instance
                .objectNode()
                .put("t", "refused")
                .put("id", id)
                .put("text", why);
    }

    /** Closes it; what was sent before goes out first where the front reads. */
    void end(int code, String why) {
        if (ended.compareAndSet(false, true)) {
            socket.ifPresent(one -> {
                if (outbox.isIdle()) {
                    one.close(code, why, Callback.NOOP);
                } else {
                    one.close(code, why, Callback.from(() -> {}, fault -> one.disconnect()));
                }
            });
            listener.closed();
        }
    }

    /** Cuts it off where it answers nothing. */
    void cut() {
        end(StatusCode.POLICY_VIOLATION, "it does not answer");
        socket.ifPresent(Session::disconnect);
    }

    @Override
    public void onWebSocketOpen(Session session) {
        socket = Optional.of(session);
        listener.opened();
    }

    @Override
    public void onWebSocketText(String text) {
        heardNanos = nanos.getAsLong();
        if (ended.get()) {
            return;
        }
        if (!allowance.allows()) {
            refuse(0, "more than " + (int) MESSAGES_PER_SECOND + " messages a second");
            end(StatusCode.POLICY_VIOLATION, "too many messages");
            return;
        }
        try {
            listener.received(FrontMessage.read(text));
        } catch (MalformedMessageException wrong) {
            malformed(0, wrong);
        }
    }

    /** Refuses a message that is none; too many end the connection. */
    synchronized void malformed(long id, MalformedMessageException wrong) {
        send(refusal(id, String.valueOf(wrong.getMessage())).put("bad", true).toString());
        if (++malformed >= MOST_MALFORMED) {
            end(StatusCode.POLICY_VIOLATION, "too many messages that are none");
        }
    }

    @Override
    public void onWebSocketBinary(ByteBuffer payload, Callback callback) {
        callback.succeed();
        end(StatusCode.BAD_DATA, "messages are text");
    }

    @Override
    public void onWebSocketPong(ByteBuffer payload) {
        heardNanos = nanos.getAsLong();
    }

    @Override
    public void onWebSocketError(Throwable cause) {
        gone();
    }

    @Override
    public void onWebSocketClose(int code, String reason, Callback callback) {
        callback.succeed();
        gone();
    }

    private void gone() {
        if (ended.compareAndSet(false, true)) {
            listener.closed();
        }
    }
}
