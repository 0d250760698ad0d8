package org.sami.session.server;

import org.eclipse.jetty.http.HttpStatus;
import org.eclipse.jetty.server.Handler;
import org.eclipse.jetty.server.Request;
import org.eclipse.jetty.server.Response;
import org.eclipse.jetty.util.Callback;

/** Asks fronts that fetch logs of a base which does not hold the session to come again: they find the one that does by then. Passes on all other requests. */
final class StandbyLogHandler extends Handler.Wrapper {
    @Override
    public boolean handle(Request request, Response response, Callback callback) throws Exception {
        if (!LogHandler.isOfLogs(Request.getPathInContext(request))) {
            return super.handle(request, response, callback);
        }
        TicketHandler.say(
                response, HttpStatus.SERVICE_UNAVAILABLE_503, "this base does not hold the session", callback);
        return true;
    }
}
