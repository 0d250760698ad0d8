package org.sami.session.server;

import org.eclipse.jetty.websocket.api.Callback;
import org.eclipse.jetty.websocket.api.Session;
import org.eclipse.jetty.websocket.api.StatusCode;

/** A front that has come to a standby: it is told so, and the connection ends. What it sends is not read. Public as Jetty calls it. */
public final class StandbyFront implements Session.Listener.AutoDemanding {
    private final String message;

    StandbyFront(String message) {
        this.message = message;
    }

    @Override
    public void onWebSocketOpen(Session session) {
        Runnable close = () -> session.close(StatusCode.TRY_AGAIN_LATER, "a standby", Callback.NOOP);
        session.sendText(message, Callback.from(close, fault -> session.disconnect()));
    }
}
