package org.sami.spn.host;

import java.lang.System.Logger.Level;
import org.jspecify.annotations.Nullable;

/** Whether a host works: notifies its listeners when that changes. A host that has ended stays so. Safe for use by several threads. */
final class HostLifecycle {
    private static final System.Logger LOG = System.getLogger(HostLifecycle.class.getName());

    private final ListenerList<HostListener> listeners;
    private volatile HostStatus status = HostStatus.running();

    HostLifecycle(ListenerList<HostListener> listeners) {
        this.listeners = listeners;
    }

    HostStatus status() {
        return status;
    }

    boolean isRunning() {
        return status.kind() == HostStatus.Kind.RUNNING;
    }

    boolean isWaiting() {
        return status.kind() == HostStatus.Kind.WAITING;
    }

    /** It waits for its journal from now on, or waits still. */
    void waits(HostStatus waiting, Throwable fault) {
        boolean isNew = !status.reason().equals(waiting.reason());
        if (become(waiting) && isNew) {
            LOG.log(Level.ERROR, "the engine's host waits: " + waiting.whole(), fault);
            listeners.each(listener -> listener.onWaiting(waiting));
        }
    }

    /** It has waited, and runs again; gives whether it does. */
    boolean goesOn() {
        if (!become(HostStatus.running())) {
            return false;
        }
        LOG.log(Level.INFO, "the engine's host goes on: its journal is written again");
        listeners.each(HostListener::onGoingOn);
        return true;
    }

    void closed() {
        become(new HostStatus(HostStatus.Kind.CLOSED, "closed"));
    }

    /** It has stopped by a fault; null for one that was found elsewhere. */
    void failed(HostStatus failed, @Nullable Throwable fault) {
        if (become(failed)) {
            LOG.log(Level.ERROR, "the engine's host stops: " + failed.whole(), fault);
            listeners.each(listener -> listener.onFailed(failed));
        }
    }

    private synchronized boolean become(HostStatus next) {
        if (!status.isAlive()) {
            return false;
        }
        status = next;
        return true;
    }
}
