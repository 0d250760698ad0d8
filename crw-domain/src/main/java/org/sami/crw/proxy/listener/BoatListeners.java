package org.sami.crw.proxy.listener;

import java.util.function.Consumer;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.proxy.command.Upload;
import org.sami.crw.proxy.link.LeftOut;
import org.sami.crw.proxy.queue.CommandQueueSnapshot;
import org.sami.crw.proxy.queue.Withdrawal;
import org.sami.crw.proxy.status.BatteryState;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.spn.host.ListenerList;
import org.sami.spn.value.GeoPoint;

/** Several listeners as one, called in order. An exception of one is logged and reported to all; the next ones are still called. */
public final class BoatListeners implements BoatListener {
    private final ListenerList<BoatListener> listeners = new ListenerList<>();

    /** The listeners in the order in which they are told. */
    public BoatListeners(BoatListener... listeners) {
        for (BoatListener listener : listeners) {
            this.listeners.add(listener);
        }
    }

    @Override
    public void onCompleted(String boatId, BoatCommand command) {
        each(listener -> listener.onCompleted(boatId, command));
    }

    @Override
    public void onFailed(String boatId, BoatCommand command, String reason) {
        each(listener -> listener.onFailed(boatId, command, reason));
    }

    @Override
    public void onHoldsPlace(String boatId, BoatCommand givenUp) {
        each(listener -> listener.onHoldsPlace(boatId, givenUp));
    }

    @Override
    public void onWithdrawn(String boatId, BoatCommand command, Withdrawal why) {
        each(listener -> listener.onWithdrawn(boatId, command, why));
    }

    @Override
    public void onQueueChanged(String boatId, CommandQueueSnapshot queue) {
        each(listener -> listener.onQueueChanged(boatId, queue));
    }

    @Override
    public void onPanorama(String boatId, BoatCommand command, int pictures, GeoPoint from) {
        each(listener -> listener.onPanorama(boatId, command, pictures, from));
    }

    @Override
    public void onProgress(String boatId, BoatCommand command, int visitedCount) {
        each(listener -> listener.onProgress(boatId, command, visitedCount));
    }

    @Override
    public void onUpload(String boatId, Upload upload) {
        each(listener -> listener.onUpload(boatId, upload));
    }

    @Override
    public void onTakenOver(String boatId) {
        each(listener -> listener.onTakenOver(boatId));
    }

    @Override
    public void onReleased(String boatId) {
        each(listener -> listener.onReleased(boatId));
    }

    @Override
    public void onStatus(BoatStatus status) {
        each(listener -> listener.onStatus(status));
    }

    @Override
    public void onLinkChange(BoatStatus status) {
        each(listener -> listener.onLinkChange(status));
    }

    @Override
    public void onBattery(String boatId, BatteryState battery) {
        each(listener -> listener.onBattery(boatId, battery));
    }

    @Override
    public void onRestarted(BoatStatus status) {
        each(listener -> listener.onRestarted(status));
    }

    @Override
    public void onRestartAllowed(BoatStatus status) {
        each(listener -> listener.onRestartAllowed(status));
    }

    @Override
    public void onRetired(String boatId) {
        each(listener -> listener.onRetired(boatId));
    }

    @Override
    public void onCommanding(String boatId, boolean commands) {
        each(listener -> listener.onCommanding(boatId, commands));
    }

    @Override
    public void onCommandAsked(String boatId, String clientId) {
        each(listener -> listener.onCommandAsked(boatId, clientId));
    }

    @Override
    public void onReading(String boatId, BoatReading reading) {
        each(listener -> listener.onReading(boatId, reading));
    }

    @Override
    public void onLeftOut(String boatId, LeftOut leftOut) {
        each(listener -> listener.onLeftOut(boatId, leftOut));
    }

    @Override
    public void onTuning(String boatId, BoatTuning tuning) {
        each(listener -> listener.onTuning(boatId, tuning));
    }

    @Override
    public void onTuningTaken(String boatId, String commandId) {
        each(listener -> listener.onTuningTaken(boatId, commandId));
    }

    @Override
    public void onTuningRefused(String boatId, String commandId, String reason) {
        each(listener -> listener.onTuningRefused(boatId, commandId, reason));
    }

    @Override
    public void onRefused(String boatId, String reason) {
        each(listener -> listener.onRefused(boatId, reason));
    }

    @Override
    public void onListenerFault(String listener, Throwable fault) {
        listeners.each(other -> other.onListenerFault(listener, fault));
    }

    private void each(Consumer<BoatListener> news) {
        listeners.each(
                news, (listener, fault) -> onListenerFault(listener.getClass().getName(), fault));
    }
}
